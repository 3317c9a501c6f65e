#pragma once

#include <string>

#include "arm_cell.hpp"
#include "symscene/picking/simulated_picks.hpp"
#include "table_belief.hpp"

namespace symscene {

/// Records what a run shows: poses at a fixed rate, beliefs and events.
class RunRecorder {
 public:
  /// References are kept.
  RunRecorder(const PickTable& table, const RobotSolids& robot, const TriangleMesh& bin,
              double rate, const PickObserver& observer);

  /// Records the poses of a moment, if it is due.
  void step(const ArmCell& cell);
  void add(const TableBelief& belief, double time);
  void add(double time, const std::string& text, RecordedOutcome outcome = RecordedOutcome::note);
  RunRecording take() { return std::move(recording_); }

 private:
  const RobotSolids& robot_;
  const PickObserver& observer_;
  double interval_;
  double next_ = 0.0;
  RunRecording recording_;
};

}  // namespace symscene
