#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/robots/robot_model.hpp"

namespace symscene {

struct MotionObstacleOptions {
  double own_reach = 0.05;
  bool never_seen = true;
  double start_clearance = 0.05;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("own_reach", self.own_reach, "m", between(0.0, 1.0),
          "never-seen space within this distance of an object, if no other is nearer, is no "
          "obstacle while that object is grasped");
    visit("never_seen", self.never_seen, "", any_value(),
          "space near the objects that was never seen is an obstacle where an object could stand: "
          "above "
          "the table nothing below it is free, and it is no higher than the highest seen surface");
    visit("start_clearance", self.start_clearance, "m", between(0.0, 1.0),
          "never-seen space within this distance of the robot at its start is free: the robot is "
          "there");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// What a robot can meet.
enum class ObstacleKind : std::uint8_t {
  object,      ///< the completed surface of one
  surface,     ///< observed points of no object, or occupied space
  never_seen,  ///< space that was not observed and in which an object could stand
  table,
  robot  ///< another link
};
/// The name of the enumerator.
const char* to_string(ObstacleKind kind);

/// An obstacle near a part of the robot.
struct ObstacleDistance {
  double distance = 0.0;  ///< negative: depth [m]
  ObstacleKind kind = ObstacleKind::surface;
  int object =
      -1;  ///< the object, or that in whose surroundings never-seen space lies; −1 for none
};

/// What is left out of a check.
struct IgnoredObstacles {
  int surface_of = -1;     ///< an object that may be touched
  int never_seen_at = -1;  ///< an object whose never-seen surroundings count as free
};

/// The obstacles of a scene in the world frame: completed surfaces of its objects, other points,
/// occupied and never-seen space as small balls in a grid of cells, with a distance field that
/// tells fast where none of them is near; the table as a half space. Never-seen space counts where
/// an object on the table could reach it: see FreeColumns. Space outside the scene's grid counts as
/// free.
class MotionObstacles {
 public:
  /// Distances are told up to this. [m]
  static constexpr double near = 0.04;

  /// `robot_at_start`: capsules in the world; never-seen space near them is free.
  MotionObstacles(const GraspScene& scene, const std::vector<Capsule>& robot_at_start = {},
                  const MotionObstacleOptions& options = {});

  /// A lower bound of the distance of a point from all but the table; cheap. [m]
  double bound_at(const Eigen::Vector3d& point) const;
  /// The nearest obstacle but the table that is nearer than `up_to`; none if there is none. [m]
  std::optional<ObstacleDistance> nearest(const Capsule& capsule, const IgnoredObstacles& ignored,
                                          double up_to = near) const;
  std::optional<ObstacleDistance> nearest(const Eigen::AlignedBox3d& box,
                                          const Eigen::Isometry3d& T_world_box,
                                          const IgnoredObstacles& ignored) const;
  const std::optional<Plane>& table() const { return table_; }

 private:
  struct Ball {
    Eigen::Vector3f centre;
    float radius;
    std::int16_t object;
    ObstacleKind kind;
  };

  void add_space(const OccupancyGrid& space,
                 const std::vector<std::vector<Eigen::Vector3f>>& surfaces,
                 const std::vector<Capsule>& robot_at_start, const MotionObstacleOptions& options);
  void sort_into_cells();
  void make_field();
  template <class Visit>
  void visit_near(const Eigen::Vector3d& min, const Eigen::Vector3d& max, const Visit& visit) const;
  std::size_t cell_index(const Eigen::Vector3i& cell) const;

  std::optional<Plane> table_;
  std::vector<Ball> balls_;
  double greatest_radius_ = 0.0;
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero();
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<std::uint32_t> begins_;  ///< of the balls of each cell, and the end of the last
  std::optional<DistanceField> field_;
};

}  // namespace symscene
