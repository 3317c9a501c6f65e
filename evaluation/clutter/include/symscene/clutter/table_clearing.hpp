#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/clutter/clutter_rounds.hpp"
#include "symscene/clutter/table_grasps.hpp"
#include "symscene/clutter/table_world.hpp"

namespace symscene {

struct TableClearingOptions {
  int min_objects = 1;
  int max_objects = 12;
  int max_failures = 2;  ///< in a row, which end the clearing
  int max_looks = 0;     ///< after which a table is left as it is; 0 for no bound
  /// The best grasp of each object of the first look is tried and undone.
  bool try_each_object = false;
  std::uint64_t seed = 0;
  GraspMethod method = GraspMethod::symscene;
  /// Table, camera and sensor. Seed and number of objects are set per table.
  SweepOptions sweep = default_sweep();
  TableLookOptions look;
  PipelineOptions pipeline;
  GraspOptions grasping;
  GraspExecutionOptions execution;
  GraspWorldOptions physics;

  /// Objects spread over 0.6 m of a table of 1.2 by 1.2 m above a floor, and a sweep of 60 frames
  /// over 60 degrees.
  static SweepOptions default_sweep();
  /// Throws InputError if a value is out of its range or the method needs true meshes.
  void validate() const;
};

/// A true object and what the first look found of it.
struct FirstLookObject {
  std::string name;
  bool graspable = false;             ///< Graspability::at_all
  bool graspable_as_it_lies = false;  ///< Graspability::as_it_lies
  bool found = false;                 ///< most points of a found object are on it
  std::size_t grasps = 0;             ///< of the found objects whose points are mostly on it
  std::string reason;                 ///< why it has none
  std::optional<GraspEnd> end = {};   ///< of the best of them, with try_each_object
};

/// A look at a table, and the execution of the best grasp that was proposed for it.
struct TableAttempt {
  int number = 1;  ///< of the look
  std::size_t present = 0;
  std::size_t found = 0;  ///< objects that the method finds
  std::size_t frames = 0;
  std::size_t fused = 0;
  double drift = 0.0;  ///< root mean square error of the tracked positions [m]
  double reconstruction_seconds = 0.0;
  double segmentation_seconds = 0.0;
  double grasping_seconds = 0.0;
  bool tried = false;  ///< there was a grasp; the following describe it
  Grasp grasp = {};    ///< in the world frame
  GraspOutcome outcome = {};
  std::string aimed;            ///< name of the object nearest to the point between the fingertips
  double aimed_distance = 0.0;  ///< of that point from its surface [m]
  double penetration = 0.0;     ///< of the open hand at the grasp, into table or other objects [m]
  bool touched_other = false;   ///< the approach was stopped by another object
  bool removed_other = false;   ///< another object was removed

  bool succeeded() const { return tried && outcome.end == GraspEnd::success; }
};

/// A table that was cleared as far as it could be.
struct TableClearing {
  int table = 0;
  int placed = 0;
  int removed = 0;
  int fallen = 0;             ///< pushed off
  int removed_graspable = 0;  ///< of those that are Graspability::at_all
  RoundEnd end = RoundEnd::cleared;
  bool stopped = false;           ///< after max_looks, with objects left: there is no end
  std::vector<std::string> left;  ///< names of the objects at the end
  std::vector<FirstLookObject> first_look;
  std::vector<TableAttempt> attempts;  ///< one per look; the last can be without a grasp
  std::vector<std::string> warnings;   ///< models that found no place
};

/// Called after each look and its attempt.
using TableObserver = std::function<void(const TableAttempt&)>;

/// Drops scanned models onto a table and clears it with the Panda hand: a look, the best grasp, and
/// again, until nothing is left, no grasp is proposed or grasps fail in a row, or max_looks. Table
/// k has min_objects + k mod (max_objects − min_objects + 1) objects. The same options give the
/// same clearing, apart from times, whichever tables were cleared before. Throws InputError if an
/// option is out of its range, no model can be used, or this build has no physics.
TableClearing clear_table(std::span<const ObjectModel> models, const TableClearingOptions& options,
                          int table, const TableObserver& observer = {});

}  // namespace symscene
