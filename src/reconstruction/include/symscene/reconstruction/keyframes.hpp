#pragma once

#include <cstddef>
#include <vector>

#include "symscene/reconstruction/measurement.hpp"

namespace symscene {

/// A view that tracking remembers: where it was taken, and a tiny depth image to know it by.
struct Keyframe {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  std::vector<float> thumbnail;  ///< mean depths, 0 where nothing was measured [m]
};

/// The keyframes of a sequence, by which a camera that is lost is found (after Glocker et al. 2013,
/// who compare small codes of images in the same way).
class Keyframes {
 public:
  /// Remembers a view unless one that is less than `distance` and `angle` away is remembered.
  void add(const Measurement& measurement, const Eigen::Isometry3d& T_world_camera, double distance,
           double angle);

  /// The poses of at most `count` keyframes that look most like a measurement, best first.
  std::vector<Eigen::Isometry3d> most_similar(const Measurement& measurement,
                                              std::size_t count) const;

  std::size_t size() const { return keyframes_.size(); }

 private:
  std::vector<Keyframe> keyframes_;
};

}  // namespace symscene
