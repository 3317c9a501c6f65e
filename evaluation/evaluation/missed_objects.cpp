#include "symscene/evaluation/missed_objects.hpp"

#include <algorithm>

#include "core/thinned_size.hpp"
#include "failure_picture.hpp"
#include "symmetry_targets.hpp"

namespace symscene {
namespace {

constexpr double found_overlap = 0.9;
constexpr double proposed_overlap = 0.5;  // least overlap of a proposal that proposes an object

/// A true object with its mask in the cloud of the proposals.
struct Target {
  const TrueObject& object;
  const PointIndices& mask;

  double overlap(const PointIndices& points) const { return intersection_over_union(mask, points); }
  bool has_symmetry() const {
    return object.sphere || !object.rotational.empty() || !object.reflectional.empty();
  }
  bool holds_most_of(const PointIndices& support) const {
    return 2 * intersection_size(mask, support) > support.size();
  }
};

/// The position of a reason in the order in which proposals are rejected.
std::size_t stage_of(const std::string& reason) {
  static constexpr std::array order = {"support", "size",  "symmetry",  "occlusion", "smoothness",
                                       "score",   "merge", "composite", "overlap"};
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), reason) - order.begin());
}

/// The hypothesis or proposal that overlaps a target best.
struct BestProposal {
  double overlap = 0.0;
  const PointIndices* points = nullptr;

  void consider(const Target& target, const PointIndices& candidate) {
    const double value = target.overlap(candidate);
    if (points == nullptr || value > overlap) *this = {value, &candidate};
  }
};

BestProposal best_proposal(const Target& target, const SceneProposals& proposals) {
  BestProposal best;
  for (const Hypothesis& hypothesis : proposals.rotational)
    best.consider(target, hypothesis.points);
  for (const Hypothesis& hypothesis : proposals.reflectional)
    best.consider(target, hypothesis.points);
  for (const Rejection& rejection : proposals.rejected) best.consider(target, rejection.points);
  for (const ObjectProposal& proposal : proposals.objects)
    best.consider(target, proposal.merged.points);
  return best;
}

/// Why the proposals with IoU > 0.9 were rejected. One that was not rejected has been merged into
/// an object with another mask.
std::string rejection_reason(const Target& target, const SegmentationResult& result) {
  std::string reason;
  for (const Rejection& rejection : result.rejected) {
    if (target.overlap(rejection.points) <= found_overlap) continue;
    if (reason.empty() || stage_of(rejection.reason) > stage_of(reason)) reason = rejection.reason;
  }
  return reason.empty() ? "merge" : reason;
}

template <class Candidates, class IsSymmetry>
void look_for_proposal(const Target& target, const Candidates& candidates,
                       const IsSymmetry& is_symmetry, bool& any_segment, bool& any_symmetry) {
  for (const auto& candidate : candidates) {
    if (!target.holds_most_of(candidate.support)) continue;
    any_segment = true;
    any_symmetry = any_symmetry || !target.has_symmetry() || is_symmetry(candidate);
  }
}

/// Why no candidate proposes the target; empty if one does.
std::string missing_proposal(const Target& target, const SceneProposals& proposals) {
  bool any_segment = false;
  bool any_symmetry = false;
  look_for_proposal(
      target, proposals.axes,
      [&](const RotationalCandidate& c) { return is_symmetry_of(target.object, c.axis); },
      any_segment, any_symmetry);
  look_for_proposal(
      target, proposals.planes,
      [&](const ReflectionalCandidate& c) { return is_symmetry_of(target.object, c.plane); },
      any_segment, any_symmetry);
  if (any_symmetry) return "";
  return any_segment ? "no symmetry" : "no segment";
}

/// "too little" or "too much" of the target.
std::string segmentation_error(const Target& target, const BestProposal& best) {
  if (best.points == nullptr) return "too little";
  const std::size_t common = intersection_size(target.mask, *best.points);
  const std::size_t missing = target.mask.size() - common;
  const std::size_t foreign = best.points->size() - common;
  return missing >= foreign ? "too little" : "too much";
}

void judge_outcome(const Target& target, const SceneProposals& proposals,
                   const SegmentationResult& result, ObjectOutcome& outcome) {
  if (target.mask.empty()) {
    outcome.outcome = Outcome::lost;
    outcome.reason = "no point";
    return;
  }
  const BestProposal best = best_proposal(target, proposals);
  outcome.best_proposal_overlap = best.overlap;
  if (outcome.best_overlap > found_overlap) return;
  if (best.overlap > found_overlap) {
    outcome.outcome = Outcome::rejected;
    outcome.reason = rejection_reason(target, result);
    return;
  }
  if (best.overlap <= proposed_overlap) outcome.reason = missing_proposal(target, proposals);
  outcome.outcome = outcome.reason.empty() ? Outcome::wrongly_segmented : Outcome::not_proposed;
  if (outcome.outcome == Outcome::wrongly_segmented)
    outcome.reason = segmentation_error(target, best);
}

/// Counts the next `count` entries of `match.truth_met`, which are those of one object.
void count_met(const SymmetryMatch& match, std::size_t count, std::size_t& next,
               ObjectOutcome& outcome) {
  outcome.symmetries += count;
  for (std::size_t k = 0; k < count; ++k) outcome.symmetries_met += match.truth_met[next++] ? 1 : 0;
}

}  // namespace

std::string outcome_name(Outcome outcome) {
  static constexpr std::array names = {"found", "not proposed", "wrongly segmented", "rejected",
                                       "lost before segmentation"};
  static_assert(names.size() == all_outcomes.size());
  return names[static_cast<std::size_t>(outcome)];
}

std::vector<ObjectOutcome> object_outcomes(const SceneTruth& truth,
                                           const std::vector<PointIndices>& masks,
                                           const SceneProposals& proposals,
                                           const SegmentationResult& result) {
  const SymmetryTolerance near;
  const SymmetryMatch axes = match_axes(truth, all_axes(result.objects), near);
  const SymmetryMatch planes = match_planes(truth, all_planes(result.objects), near);
  const std::vector<std::size_t> axis_counts = axis_targets(truth);
  const std::vector<std::size_t> plane_counts = plane_targets(truth);
  std::size_t next_axis = 0;
  std::size_t next_plane = 0;
  std::vector<ObjectOutcome> outcomes;
  for (std::size_t k = 0; k < truth.objects.size(); ++k) {
    const Target target{truth.objects[k], masks.at(k)};
    ObjectOutcome outcome;
    outcome.kind = truth.objects[k].name;
    outcome.points = target.mask.size();
    outcome.is_small = thinned_size(result.cloud.positions, target.mask) < small_object_points;
    for (const SceneObject& object : result.objects)
      outcome.best_overlap = std::max(outcome.best_overlap, target.overlap(object.points));
    judge_outcome(target, proposals, result, outcome);
    show_failure(target.mask, result, outcome);
    count_met(axes, axis_counts[k], next_axis, outcome);
    count_met(planes, plane_counts[k], next_plane, outcome);
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace symscene
