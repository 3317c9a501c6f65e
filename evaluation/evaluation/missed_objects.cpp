#include "symscene/evaluation/missed_objects.hpp"

#include <algorithm>

namespace symscene {
namespace {

constexpr double found_overlap = 0.9;
constexpr double proposed_overlap = 0.5;  // of the best cut or part with an object that is proposed

/// A true object with its points where the proposals count.
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

/// The order in which refusals happen.
std::size_t stage_of(const std::string& reason) {
  static constexpr std::array order = {"support", "size",  "symmetry",  "occlusion", "smoothness",
                                       "score",   "merge", "composite", "overlap"};
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), reason) - order.begin());
}

/// The cut, or part of the surface, that overlaps a target best.
struct BestCut {
  double overlap = 0.0;
  const PointIndices* points = nullptr;

  void consider(const Target& target, const PointIndices& cut) {
    const double value = target.overlap(cut);
    if (points == nullptr || value > overlap) *this = {value, &cut};
  }
};

BestCut best_cut(const Target& target, const SceneProposals& proposals) {
  BestCut best;
  for (const Hypothesis& cut : proposals.rotational) best.consider(target, cut.points);
  for (const Hypothesis& cut : proposals.reflectional) best.consider(target, cut.points);
  for (const Rejection& cut : proposals.rejected) best.consider(target, cut.points);
  for (const ObjectProposal& proposal : proposals.objects)
    best.consider(target, proposal.object.points);
  return best;
}

/// Which bound or rival refused a good cut of the target. One that nothing refused became part of
/// an object with another mask.
std::string refusal(const Target& target, const SegmentationResult& result) {
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

std::string wrong_cut(const Target& target, const BestCut& cut) {
  if (cut.points == nullptr) return "too little";
  const std::size_t common = intersection_size(target.mask, *cut.points);
  const std::size_t missing = target.mask.size() - common;
  const std::size_t foreign = cut.points->size() - common;
  return missing >= foreign ? "too little" : "too much";
}

void judge_outcome(const Target& target, const SceneProposals& proposals,
                   const SegmentationResult& result, ObjectOutcome& outcome) {
  const BestCut cut = best_cut(target, proposals);
  outcome.best_proposal_overlap = cut.overlap;
  if (outcome.best_overlap > found_overlap) return;
  if (cut.overlap > found_overlap) {
    outcome.fate = Fate::rejected;
    outcome.reason = refusal(target, result);
    return;
  }
  if (cut.overlap <= proposed_overlap) outcome.reason = missing_proposal(target, proposals);
  outcome.fate = outcome.reason.empty() ? Fate::wrongly_segmented : Fate::not_proposed;
  if (outcome.fate == Fate::wrongly_segmented) outcome.reason = wrong_cut(target, cut);
}

/// Sums the next `count` entries of a scene's list of met symmetries.
void count_met(const SymmetryMatch& match, std::size_t count, std::size_t& next,
               ObjectOutcome& outcome) {
  outcome.symmetries += count;
  for (std::size_t k = 0; k < count; ++k) outcome.symmetries_met += match.truth_met[next++] ? 1 : 0;
}

}  // namespace

std::string fate_name(Fate fate) {
  static constexpr std::array names = {"found", "not proposed", "wrongly segmented", "rejected"};
  static_assert(names.size() == all_fates.size());
  return names[static_cast<std::size_t>(fate)];
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
    for (const SceneObject& object : result.objects)
      outcome.best_overlap = std::max(outcome.best_overlap, target.overlap(object.points));
    judge_outcome(target, proposals, result, outcome);
    count_met(axes, axis_counts[k], next_axis, outcome);
    count_met(planes, plane_counts[k], next_plane, outcome);
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace symscene
