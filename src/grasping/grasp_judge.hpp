#pragma once

#include <optional>

#include "approach_poses.hpp"
#include "contacts.hpp"
#include "hand_shape.hpp"
#include "target.hpp"
#include "unknown_space.hpp"

namespace symscene {

/// All that the gripper may meet: the closed surfaces of the objects, other points, and space that
/// is occupied or was never seen.
struct GraspSurroundings {
  const GraspScene& scene;
  std::vector<SurfaceSamples> objects;  ///< one per object of the scene
  SurfaceSamples others;
  std::optional<UnknownSpace> unknown;
  Eigen::Vector3d seen_from;  ///< mean_seen_normal() of the objects
};

/// Judges grasps of one object.
class GraspJudge {
 public:
  /// Keeps references to all of these.
  GraspJudge(const GraspSurroundings& around, const GraspTarget& target, const Gripper& gripper,
             const GraspOptions& options);

  /// The grasp at a pose, centred between its contacts, with features and quality; or the first
  /// bound that it fails, and its features so far.
  struct Verdict {
    Grasp grasp;
    std::optional<GraspRejection> reason;
    double value = 0.0;
    double bound = 0.0;
  };
  /// How far the distances of a rejected grasp are searched.
  enum class Search {
    to_bound,  ///< to the first distance below the bound, so that `value` is below it
    complete   ///< to the least distance
  };
  Verdict judge(const ApproachPose& pose, Search search) const;

 private:
  void require_contact(Verdict& verdict, Search search) const;
  void judge_contacts(Verdict& verdict, const Contacts& contacts) const;
  void judge_weight(Verdict& verdict, const Contacts& contacts) const;
  void require_clear_way(Verdict& verdict, Search search) const;
  void require_clear_retreat(Verdict& verdict, Search search) const;
  /// Adds a rejection if the boxes are too near to other objects.
  void require_clear_of_others(Verdict& verdict, const Eigen::Isometry3d& T_world_tool,
                               std::span<const HandBox> boxes, Search search) const;
  void require_seen_space(Verdict& verdict, Search search) const;
  double unknown_share(const Eigen::Matrix3Xf& points, const Eigen::Isometry3f& T_world_tool) const;
  /// The least height of the open gripper over the table on its way, or greatest_distance. [m]
  double height_on_way(const Eigen::Isometry3d& T_world_tool) const;
  /// The least distance of the samples from the gripper, up to greatest_distance. [m]
  float distance_from(const SurfaceSamples& samples, const Eigen::Isometry3d& T_world_tool,
                      std::span<const HandBox> boxes, double bound, Search search) const;

  const GraspSurroundings& around_;
  const GraspTarget& target_;
  const Gripper& gripper_;
  const GraspOptions& options_;
  HandShape swept_;                 ///< the open gripper on its way to the grasp
  HandBox between_;                 ///< between its fingers
  Eigen::Matrix3Xf finger_points_;  ///< in the swept fingers, tool frame
  Eigen::Matrix3Xf palm_points_;
  SurfaceSamples obstacles_;  ///< what the gripper can reach of other objects
};

}  // namespace symscene
