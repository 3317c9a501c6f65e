#pragma once

#include <cstddef>
#include <vector>

#include "reconstruction/measurement.hpp"
#include "symscene/reconstruction/tracking_options.hpp"

namespace symscene {

/// A view by which a lost camera can be found.
struct Keyframe {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  std::vector<float> thumbnail;  ///< mean depths, 0 where nothing was measured [m]
};

/// The keyframes of a sequence (after Glocker et al. 2013, who compare small codes of images).
class Keyframes {
 public:
  explicit Keyframes(const TrackingOptions& options) : options_(options) {}

  /// Adds a view unless a keyframe is closer than `keyframe_distance` and `keyframe_angle`.
  void add(const Measurement& measurement, const Eigen::Isometry3d& T_world_camera);

  /// The poses of at most `count` keyframes, the most similar to the measurement first.
  std::vector<Eigen::Isometry3d> most_similar(const Measurement& measurement,
                                              std::size_t count) const;

  std::size_t size() const { return keyframes_.size(); }

 private:
  TrackingOptions options_;
  std::vector<Keyframe> keyframes_;
};

}  // namespace symscene
