#include "left_reasons.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace symscene {
namespace {

/// The reason that most grasps failed for, with the detail of the best of these grasps.
std::string unreachable_reason(const std::vector<RejectedPick>& rejected) {
  std::array<int, pick_rejections> counts{};
  for (const RejectedPick& pick : rejected) ++counts.at(static_cast<std::size_t>(pick.reason));
  const auto most = std::max_element(counts.begin(), counts.end());
  const auto reason = static_cast<PickRejection>(most - counts.begin());
  const auto first = std::find_if(rejected.begin(), rejected.end(),
                                  [&](const RejectedPick& pick) { return pick.reason == reason; });
  std::string text =
      fmt::format("the arm cannot take its {} grasps: {}", rejected.size(), description(reason));
  if (!first->detail.empty()) text += " (" + first->detail + ")";
  return text;
}

std::string belief_reason(const std::optional<BeliefFate>& fate) {
  if (!fate) return "not found as an object of its own at the last look";
  if (fate->no_grasp) return fmt::format("no grasp: {}", description(*fate->no_grasp));
  if (!fate->rejected.empty()) return unreachable_reason(fate->rejected);
  if (fate->given_up > 0)
    return fmt::format("its {} grasps are given up after failed attempts", fate->given_up);
  return "it has grasps that were not tried";
}

std::string failed_text(std::span<const PickAttempt> attempts) {
  return fmt::format("{} failed attempt{}, the last: {}", attempts.size(),
                     attempts.size() == 1 ? "" : "s", description(attempts.back().end));
}

}  // namespace

std::string reason_left(const std::optional<BeliefFate>& fate,
                        std::span<const PickAttempt> attempts) {
  const std::string belief = belief_reason(fate);
  if (attempts.empty()) return belief;
  return failed_text(attempts) + "; " + belief;
}

std::string reason_fallen(std::span<const PickAttempt> attempts) {
  if (attempts.empty()) return "it left the table, and no attempt aimed at it";
  return "it left the table after " + failed_text(attempts);
}

}  // namespace symscene
