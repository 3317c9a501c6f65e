#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "symscene/core/camera.hpp"
#include "symscene/core/depth_frame.hpp"
#include "symscene/core/depth_noise.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

struct LabelImageOptions {
  double noise = structured_light_noise;
  double noise_sigmas = 3.0;
  double spacings = 2.0;
  double max_slope = 5.0;
  double max_growth = 0.02;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("noise", self.noise, "1/m", at_least(0.0),
          "standard deviation of a depth over its square (Khoshelham and Elberink 2012, Eq. 10)");
    visit("noise_sigmas", self.noise_sigmas, "", at_least(0.0),
          "deviations by which a pixel may miss a point, or its neighbour on the same surface");
    visit("spacings", self.spacings, "", above(0.0),
          "distance of a pixel from a point, in spacings of the cloud, up to which it shows it");
    visit("max_slope", self.max_slope, "", above(0.0),
          "largest depth step between neighbouring pixels of one surface, in widths of a pixel");
    visit("max_growth", self.max_growth, "m", at_least(0.0),
          "greatest distance along the surface over which labels are propagated to pixels without "
          "a point");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Finds the points of a cloud in depth images. The table competes with the cloud for the pixels
/// near it, as its points are not in the cloud.
class PointsInView {
 public:
  static constexpr Index none = ~Index{0};

  /// Throws InputError if an option is out of range.
  PointsInView(const PointCloud& cloud, const std::optional<Plane>& table,
               const LabelImageOptions& options = {});

  /// Per pixel the index of the point that it shows, or `none`: the nearest point, or that of the
  /// nearest pixel on the same surface. The same for any number of threads. Throws InputError if
  /// the number of depths is not that of the camera's pixels.
  std::vector<Index> points_of(const CameraIntrinsics& camera, std::span<const float> depth,
                               const Eigen::Isometry3d& T_cloud_camera) const;

 private:
  class Growth;

  void assign_nearest(const CameraIntrinsics& camera, std::span<const float> depth,
                      const Eigen::Isometry3d& T_cloud_camera, std::vector<Index>& points) const;

  const PointCloud& cloud_;
  std::optional<Plane> table_;
  LabelImageOptions options_;
  double spacing_;
  CellList cells_;
};

/// Per pixel k + 1 if its point belongs to mask k, otherwise 0. Where masks share a point, the
/// first has it. Throws InputError if there are more than 65,535 masks or a mask names a point that
/// the cloud of `point_count` points does not have.
std::vector<std::uint16_t> label_image(std::span<const Index> pixel_points,
                                       std::span<const PointIndices> masks,
                                       std::size_t point_count);

/// The frame's colours, or its depths in grey, with the labels over them, each in its own colour.
/// Throws InputError if the number of labels is not that of the pixels.
Colors overlay(const CameraIntrinsics& camera, const DepthFrame& frame,
               std::span<const std::uint16_t> labels);

}  // namespace symscene
