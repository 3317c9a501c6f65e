#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arm_cell.hpp"
#include "left_reasons.hpp"
#include "symscene/clutter/graspability.hpp"

namespace symscene {

/// Keeps what became of each true object of a run.
class ObjectLedger {
 public:
  /// `table` is kept. `gripper`: with the friction of its fingers in the physics.
  ObjectLedger(const PickTable& table, const Gripper& gripper);

  /// What a look says about the objects. `present`: those on the table while it was taken, with
  /// `surfaces` where they lay.
  void note(const TableBelief& belief, const std::vector<BeliefFate>& fates,
            const std::vector<std::size_t>& present, const std::vector<TriangleMesh>& surfaces);
  /// The true object that an object of the last belief is; none if it is none.
  std::optional<std::size_t> true_object(Index believed) const {
    return true_objects_[static_cast<std::size_t>(believed)];
  }
  void note_attempt(const PickAttempt& attempt, const std::optional<std::size_t>& aim);
  void note_in_bin(std::size_t object) { entries_[object].is_in_bin = true; }
  void note_fallen(std::size_t object) { entries_[object].is_fallen = true; }

  /// Fills the counts of objects, and those that are left with their reasons. `not_looked_at`: why
  /// no look was taken; empty if there was one.
  void finish(PickRun& run, const std::string& not_looked_at) const;

 private:
  struct Entry {
    Graspability graspable;
    bool is_in_bin = false, is_fallen = false;
    std::optional<BeliefFate> fate;  ///< at the last look
    std::vector<PickAttempt> attempts;
  };
  std::string reason(const Entry& entry, const std::string& not_looked_at) const;

  const PickTable& table_;
  std::vector<Entry> entries_;                            ///< one per true object
  std::vector<std::optional<std::size_t>> true_objects_;  ///< one per believed object
};

}  // namespace symscene
