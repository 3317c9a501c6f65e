#include "inverse_plane.hpp"

namespace symscene {

std::optional<InversePlane> fit_inverse_plane(const InversePlaneMoments& m, double noise) {
  const double n = m.count, mean_u = m.u / n, mean_v = m.v / n, mean_d = m.d / n;
  const double uu = m.uu / n - mean_u * mean_u, uv = m.uv / n - mean_u * mean_v;
  const double vv = m.vv / n - mean_v * mean_v;
  const double ud = m.ud / n - mean_u * mean_d, vd = m.vd / n - mean_v * mean_d;
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0.1 * uu * vv)) return std::nullopt;
  const double b = (vv * ud - uv * vd) / determinant, c = (uu * vd - uv * ud) / determinant;
  const double squared = m.dd / n - mean_d * mean_d - b * ud - c * vd;
  if (squared > noise * noise) return std::nullopt;
  return InversePlane{mean_d - b * mean_u - c * mean_v, b, c};
}

/// With d = e⁻¹ n · (x, y, 1) for the ray (x, y, 1), n is parallel to the coefficients of d in x, y
/// and 1.
Eigen::Vector3f InversePlane::normal(const CameraIntrinsics& camera) const {
  const Eigen::Vector3d n(b * camera.fx, c * camera.fy, at(camera.cx, camera.cy));
  return -n.normalized().cast<float>();
}

}  // namespace symscene
