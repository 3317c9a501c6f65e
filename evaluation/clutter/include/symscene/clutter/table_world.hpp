#pragma once

#include <optional>
#include <vector>

#include "symscene/clutter/grasp_execution.hpp"
#include "symscene/simulation/settling.hpp"

namespace symscene {

/// The objects of a tabletop as bodies, and a hand that removes them. Their mass is the volume of
/// their mesh times the density with which they were dropped. An object that comes to lie outside
/// the area of the drop has fallen off and is taken away. World frame of the tabletop. The same
/// calls give the same poses to the last bit.
class TableWorld {
 public:
  /// Puts the objects where they are and waits until they rest. Throws InputError if an object has
  /// no volume or cannot be simulated, or this build has no physics, and PhysicsDiverged.
  TableWorld(const Tabletop& tabletop, const DropOptions& drop,
             const GraspWorldOptions& physics = {});

  /// Numbers of the tabletop's objects that are on the table, ascending.
  std::vector<std::size_t> present() const;
  const ObjectModel& model(std::size_t object) const { return tabletop_.objects[object].object; }
  /// The tabletop with the present objects where they are now, in the order of present().
  Tabletop tabletop() const;

  /// How far the open hand at a grasp reaches into the table or an object other than `aimed`. [m]
  double penetration(const Eigen::Isometry3d& T_world_tool, std::size_t aimed);

  /// Executes a grasp, takes away an object that is held, and waits until the rest has settled.
  GraspOutcome execute(const Eigen::Isometry3d& T_world_tool,
                       const GraspExecutionOptions& options = {});

  /// Executes a grasp and puts all objects back to where they were, at rest.
  GraspOutcome rehearse(const Eigen::Isometry3d& T_world_tool,
                        const GraspExecutionOptions& options = {});

 private:
  void advance_to_rest();
  bool take_away_fallen();
  void settle();

  Tabletop tabletop_;  ///< as it was at first
  double area_ = 0.0;  ///< radius beyond which an object has fallen off [m]
  Eigen::Isometry3d T_table_world_;
  std::optional<GraspWorld> world_;
};

}  // namespace symscene
