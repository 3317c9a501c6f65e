#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "ros_cursor.hpp"
#include "symscene/core/depth_frame.hpp"

namespace symscene {

/// The pose of a frame in its parent at a time.
struct RosTransform {
  RosHeader header;   ///< of the parent
  std::string child;  ///< the frame
  Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity();
};

/// Parses a message tf2_msgs/TFMessage. Throws InputError if the bytes are another message or a
/// transform is not finite.
std::vector<RosTransform> parse_ros_transforms(std::string_view bytes, RosFormat format,
                                               const std::string& name);

/// Frames and how they move, as tf records them.
class TransformTree {
 public:
  /// Static transforms hold at all times.
  void add(const RosTransform& transform, bool is_static);

  /// Sorts transforms by time; call it after the last add().
  void finish();

  /// Whether a frame moves in the root of its tree.
  bool moves(const std::string& frame) const;

  /// The pose of a frame in the root of its tree, interpolated between two transforms at most 0.1 s
  /// apart; none where a transform is missing.
  std::optional<Eigen::Isometry3d> pose(const std::string& frame, double time) const;

 private:
  struct Edge {
    std::string parent;
    bool is_static = true;
    Trajectory T_parent_child;  ///< poses of the child in the parent
  };
  /// The edges from a frame to its root.
  std::vector<const Edge*> chain(const std::string& frame) const;

  std::map<std::string, Edge> edges_;  ///< by child
};

}  // namespace symscene
