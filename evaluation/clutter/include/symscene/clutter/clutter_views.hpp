#pragma once

#include <span>
#include <vector>

#include "symscene/clutter/clutter_world.hpp"
#include "symscene/core/camera.hpp"
#include "symscene/core/depth_frame.hpp"

namespace symscene {

class Random;

/// The noise that the published methods are compared with (GIGA, Jiang et al., RSS 2021, after
/// Dex-Net 2.0, Mahler et al., RSS 2017).
struct ClutterNoiseOptions {
  bool enabled = true;
  double scale_shape = 1000.0;
  double grain_probability = 0.5;
  double grain = 0.005;
  int grain_pixels = 4;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("enabled", self.enabled, "", any_value(), "add noise; otherwise depth is exact");
    visit("scale_shape", self.scale_shape, "", at_least(1.0),
          "shape of the gamma distribution with mean 1 of a factor on all depths of an image");
    visit("grain_probability", self.grain_probability, "", between(0.0, 1.0),
          "probability that an image has grain");
    visit("grain", self.grain, "m", at_least(0.0), "standard deviation of the grain");
    visit("grain_pixels", self.grain_pixels, "px", at_least(1),
          "spacing of the grid on which grain is drawn");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// The camera of the benchmark.
CameraIntrinsics clutter_camera();
/// The same with images of a quarter of the width and height.
CameraIntrinsics small_clutter_camera();

/// T_world_camera of one view from the side, or of several views around, evenly spaced.
std::vector<Eigen::Isometry3d> clutter_view_poses(int views);

/// Adds the noise to a noise-free depth image.
std::vector<float> with_clutter_noise(const std::vector<float>& depth,
                                      const CameraIntrinsics& camera,
                                      const ClutterNoiseOptions& options, Random random);

/// What a camera sees of the world.
struct ClutterView {
  DepthFrame frame;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

/// The depth image of the world at T_world_camera, with noise.
ClutterView clutter_view(const ClutterWorld& world, const Eigen::Isometry3d& T_world_camera,
                         const ClutterNoiseOptions& options, const Random& noise);

/// The depth images of the world with noise from `seed`.
std::vector<ClutterView> clutter_views(const ClutterWorld& world, int views,
                                       const ClutterNoiseOptions& options, std::uint64_t seed);

/// Per present item: the share of its pixels in an image without the other objects that is hidden
/// by them (TARGO, Xia et al. 2024), in the first of so many views.
std::vector<double> clutter_occlusion(const ClutterWorld& world, int views);

}  // namespace symscene
