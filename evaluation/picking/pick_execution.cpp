#include "pick_execution.hpp"

#include <algorithm>

#include "contact_watch.hpp"

namespace symscene {
namespace {

/// One call of execute_pick().
class Execution {
 public:
  Execution(ArmCell& cell, const Arm& arm, const PlannedPick& planned,
            const PickExecutionOptions& options)
      : cell_(cell), arm_(arm), planned_(planned), options_(options) {}

  PickOutcome run() {
    PickOutcome outcome;
    outcome.end = carry();
    cell_.close_fingers(false);
    cell_.wait(options_.release_time);
    outcome.in_bin = cell_.empty_bin();
    const auto& in_bin = outcome.in_bin;
    const bool placed = held_ && std::find(in_bin.begin(), in_bin.end(), *held_) != in_bin.end();
    if (placed) outcome.end = AttemptEnd::in_bin;
    outcome.detail = watch_.touched();
    return outcome;
  }

 private:
  /// Up to the opening of the hand.
  AttemptEnd carry() {
    follow_watched(cell_, arm_, planned_.pick.to_pre_grasp, watch_);
    cell_.follow(arm_, planned_.pick.approach, [&] { return cell_.world().hand_contacts().any(); });
    cell_.close_fingers(true);
    cell_.wait(options_.closing_time);
    held_ = between_fingers();
    if (!held_) {
      cell_.close_fingers(false);
      cell_.wait(0.5 * options_.release_time);
      cell_.follow(arm_, planned_.pick.retreat);
      return AttemptEnd::nothing_between_fingers;
    }
    if (!follow_holding(planned_.pick.retreat)) return AttemptEnd::lost_at_lift;
    if (!follow_holding(planned_.to_bin)) return AttemptEnd::dropped;
    return AttemptEnd::missed_bin;  // unless it is found there
  }

  std::optional<std::size_t> between_fingers() const {
    const HandContacts contacts = cell_.world().hand_contacts();
    if (contacts.held.empty() || cell_.world().opening() < options_.min_width) return std::nullopt;
    return contacts.held.front();
  }

  /// Contacts come and go while an object is carried: it is lost after ten steps without one.
  bool follow_holding(const TimedPath& path) {
    constexpr int patience = 10;
    int without = 0;
    return cell_.follow(arm_, path, [&] {
      watch_.note(false);
      const std::vector<std::size_t> bodies = cell_.world().hand_contacts().bodies;
      const bool holds = std::find(bodies.begin(), bodies.end(), *held_) != bodies.end();
      without = holds ? 0 : without + 1;
      return without >= patience;
    });
  }

  ArmCell& cell_;
  const Arm& arm_;
  const PlannedPick& planned_;
  const PickExecutionOptions& options_;
  ContactWatch watch_{cell_};
  std::optional<std::size_t> held_;
};

}  // namespace

PickOutcome execute_pick(ArmCell& cell, const Arm& arm, const PlannedPick& planned,
                         const PickExecutionOptions& options) {
  return Execution(cell, arm, planned, options).run();
}

}  // namespace symscene
