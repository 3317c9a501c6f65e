#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "symscene/clutter/graspability.hpp"
#include "symscene/core/grasp.hpp"
#include "symscene/core/stage_timer.hpp"
#include "symscene/reconstruction/trajectory_error.hpp"
#include "symscene/viewer/run_page.hpp"

namespace symscene {

/// How an attempt to put an object into the bin ended.
enum class AttemptEnd : std::uint8_t {
  in_bin,
  nothing_between_fingers,  ///< after closing, no object touches both fingers
  lost_at_lift,             ///< held, but not at the end of the lift
  dropped,                  ///< on the way to the bin
  missed_bin,               ///< it came to lie outside the bin
  diverged                  ///< the physics diverged
};
/// The name of the enumerator, and a phrase for people.
const char* to_string(AttemptEnd end);
const char* description(AttemptEnd end);

/// A look at the table.
struct PickLook {
  double time = 0.0;  ///< simulated, at its end [s]
  std::size_t frames = 0;
  std::size_t fused = 0;       ///< of the frames; others were lost
  TrajectoryError trajectory;  ///< of the fused frames
  double robot_share = 0.0;    ///< of the pixels, that the robot or the bin covered
  std::string touched;         ///< what the arm touched on its way; empty for nothing
  bool is_enough = false;   ///< views were chosen, and no further one is expected to show much more
  std::size_t found = 0;    ///< objects
  std::size_t present = 0;  ///< true objects on the table
  std::size_t grasps = 0;   ///< proposed
  std::string no_pick;      ///< why no grasp was taken, if none was
  std::vector<StageTime> times;  ///< wall times of what the robot computed after it
};

/// An attempt to pick an object. World frame: that of the table.
struct PickAttempt {
  std::size_t look = 0;  ///< index of the look that it was planned from
  Grasp grasp;
  std::string object;  ///< name of the true object that it aims at
  AttemptEnd end = AttemptEnd::nothing_between_fingers;
  std::string detail;   ///< what else happened, such as an object that the arm touched
  double begin = 0.0;   ///< simulated [s]
  double finish = 0.0;  ///< simulated [s]
};

/// An object that is not in the bin at the end.
struct LeftObject {
  std::string name;
  Graspability graspable;
  std::string reason;
};

/// Why a run ended.
enum class PickRunEnd : std::uint8_t {
  cleared,        ///< no object is left on the table
  nothing_found,  ///< no object was found on the table
  no_pick,        ///< no grasp was left that the arm can take
  looks,          ///< max_looks are used up
  no_start,       ///< an arm meets something where the robot stands at first
  no_view,        ///< the arm brings its camera to no pose from which it sees the table
  diverged        ///< the physics diverged
};
const char* to_string(PickRunEnd end);
const char* description(PickRunEnd end);

/// A table that was cleared as far as it could be.
struct PickRun {
  /// Objects of a kind on the table at first, and of these in the bin at the end.
  struct Cleared {
    std::size_t placed = 0;
    std::size_t in_bin = 0;
  };
  Cleared all;
  Cleared graspable;  ///< the hand could close on them as they lay (Graspability)
  Cleared graspable_in_some_pose;
  std::size_t fallen = 0;  ///< pushed off the table
  PickRunEnd end = PickRunEnd::cleared;
  double duration = 0.0;  ///< simulated [s]
  std::vector<PickLook> looks;
  std::vector<PickAttempt> attempts;
  std::vector<LeftObject> left;
  /// Wall times of all that the robot computed until the first object was in the bin, by stage:
  /// without physics and rendering. Empty if none came there.
  std::vector<StageTime> to_first;
  std::vector<std::string> warnings;
  RunRecording recording;
};

/// run.json: everything of a run but its recording. `description`: JSON that tells what made it.
std::string format_pick_run(const PickRun& run, const std::string& description = "{}");

}  // namespace symscene
