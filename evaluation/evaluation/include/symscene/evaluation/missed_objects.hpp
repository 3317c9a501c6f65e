#pragma once

#include "symscene/evaluation/symmetry_metrics.hpp"
#include "symscene/proposals/proposals.hpp"

namespace symscene {

/// What became of a true object, in the order of the stages that can lose it.
enum class Fate {
  found,              ///< a returned mask overlaps it by more than 0.9
  not_proposed,       ///< no detected symmetry would have cut it out
  wrongly_segmented,  ///< one would have, but no cut overlaps it by more than 0.9
  rejected,           ///< such a cut there was, and it was refused
};
inline constexpr std::array all_fates = {Fate::found, Fate::not_proposed, Fate::wrongly_segmented,
                                         Fate::rejected};
/// "not proposed", and so on.
std::string fate_name(Fate fate);

/// A true object and how well a result shows it.
struct ObjectOutcome {
  std::string kind;                    ///< its name in the truth
  std::size_t points = 0;              ///< of its mask in the cloud of the result
  double best_overlap = 0.0;           ///< of a returned mask [IoU]
  double best_proposal_overlap = 0.0;  ///< of a cut, returned or refused [IoU]
  Fate fate = Fate::found;
  /// Why, one word or two; empty if found. Not proposed: "no segment" (no candidate's support lies
  /// mostly in it) or "no symmetry" (none of those is a symmetry of it). Cut wrongly: "too little"
  /// or "too much" of it. Rejected: the bound ("size", "symmetry", "occlusion", "smoothness",
  /// "support", "score"), or the competition ("merge", "composite", "overlap").
  std::string reason;
  std::size_t symmetries = 0;      ///< that have to be found
  std::size_t symmetries_met = 0;  ///< within 10° and 1 cm
};

/// What became of every object of a truth. `masks` are its objects in the proposals' cloud
/// (transfer_masks()), `result` what choose_objects() made of the proposals. An object whose truth
/// names no symmetry counts as proposed by any candidate that lies mostly in it. Where several good
/// cuts were refused, the reason is that of the one that got farthest.
std::vector<ObjectOutcome> object_outcomes(const SceneTruth& truth,
                                           const std::vector<PointIndices>& masks,
                                           const SceneProposals& proposals,
                                           const SegmentationResult& result);

}  // namespace symscene
