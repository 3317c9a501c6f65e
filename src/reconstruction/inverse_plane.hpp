#pragma once

#include <optional>

#include <Eigen/Core>

#include "symscene/core/camera.hpp"

namespace symscene {

/// A plane in an image: its inverse depth is a linear function of the pixel, a + b u + c v. [1/m]
struct InversePlane {
  double a = 0, b = 0, c = 0;

  double at(double u, double v) const { return a + b * u + c * v; }

  /// The plane's unit normal in the camera's frame, towards the camera.
  Eigen::Vector3f normal(const CameraIntrinsics& camera) const;
};

/// Sums over pixels for a least-squares fit of an InversePlane.
struct InversePlaneMoments {
  double count = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0, d = 0, ud = 0, vd = 0, dd = 0;

  void add(double x, double y, double inverse) {
    count += 1;
    u += x;
    v += y;
    uu += x * x;
    uv += x * y;
    vv += y * y;
    d += inverse;
    ud += x * inverse;
    vd += y * inverse;
    dd += inverse * inverse;
  }

  void add(const InversePlaneMoments& other) {
    count += other.count;
    u += other.u;
    v += other.v;
    uu += other.uu;
    uv += other.uv;
    vv += other.vv;
    d += other.d;
    ud += other.ud;
    vd += other.vd;
    dd += other.dd;
  }
};

/// The plane through the pixels; none if their inverse depths deviate from it by more than `noise`
/// (root mean square) or they lie on a line.
std::optional<InversePlane> fit_inverse_plane(const InversePlaneMoments& m, double noise);

}  // namespace symscene
