#pragma once

#include "symscene/evaluation/symmetry_metrics.hpp"
#include "symscene/proposals/proposals.hpp"

namespace symscene {

/// The outcome of a true object: found, or missed by one of the stages, in their order.
enum class Outcome {
  found,              ///< a returned mask overlaps it with IoU > 0.9
  not_proposed,       ///< no detected symmetry matches it and no proposal overlaps it by half
  wrongly_segmented,  ///< proposed, but no proposal overlaps it with IoU > 0.9
  rejected,           ///< some proposal does, and was rejected
  lost,               ///< it has no point in the scene's cloud: lost before segmentation
};
inline constexpr std::array all_outcomes = {Outcome::found, Outcome::not_proposed,
                                            Outcome::wrongly_segmented, Outcome::rejected,
                                            Outcome::lost};
/// An object with fewer points at 5 mm is small: reports count such objects on their own too.
inline constexpr std::size_t small_object_points = 100;
/// "not proposed", and so on.
std::string outcome_name(Outcome outcome);

/// The outcome of a true object in a result.
struct ObjectOutcome {
  std::string kind;                    ///< its name in the ground truth
  std::size_t points = 0;              ///< size of its mask in the cloud of the result
  bool is_small = false;               ///< has fewer points at 5 mm than small_object_points
  double best_overlap = 0.0;           ///< with a returned mask [IoU]
  double best_proposal_overlap = 0.0;  ///< with a hypothesis or proposal, rejected or not [IoU]
  Outcome outcome = Outcome::found;
  /// Why it was missed; empty if found. Not proposed: "no segment" (no candidate has most of its
  /// support in the object) or "no symmetry" (such candidates are not symmetries of the object).
  /// Wrongly segmented: "too little" or "too much" of the object. Rejected: the bound that rejected
  /// the proposal ("size", "symmetry", "occlusion", "smoothness", "support", "score"), or the
  /// selection ("merge", "composite", "overlap"). Lost: "no surface" or "outside the crop", where
  /// the dataset knows it, otherwise "no point".
  std::string reason;
  std::size_t symmetries = 0;      ///< strict symmetries of the ground truth
  std::size_t symmetries_met = 0;  ///< of these, found within 10° and 1 cm
  /// Of a missed object with points: what was chosen in its place, in words, and a picture of it
  /// (PNG); see show_failure().
  std::string instead;
  std::string picture;
};

/// The outcome of every object of `truth`. `masks` are the objects in the cloud of the proposals
/// (transfer_masks()), empty for those that it lacks; `result` is that of choose_objects(). An
/// object without known symmetries counts as proposed by any candidate with most of its support in
/// it. If several proposals with IoU > 0.9 were rejected, the reason is the one for which the
/// last of them was rejected.
std::vector<ObjectOutcome> object_outcomes(const SceneTruth& truth,
                                           const std::vector<PointIndices>& masks,
                                           const SceneProposals& proposals,
                                           const SegmentationResult& result);

}  // namespace symscene
