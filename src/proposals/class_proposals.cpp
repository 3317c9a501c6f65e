#include "class_proposals.hpp"

#include <algorithm>

#include "proposals/merge.hpp"
#include "segmentation/class_segmentation.hpp"
#include "symscene/classes/class_symmetries.hpp"

namespace symscene {
namespace {

std::vector<ClassSeed> seeds_of(const std::vector<ProposalDraft>& drafts,
                                const ClassSegmentationOptions& options) {
  std::vector<ClassSeed> seeds;
  for (const ProposalDraft& draft : drafts) {
    if (draft.own_score < options.min_seed_score ||
        seeds.size() == static_cast<std::size_t>(options.max_seeds))
      break;
    seeds.push_back({draft.merged.points, draft.merged.axes});
  }
  return seeds;
}

MergedHypothesis merged_with(const MergedHypothesis& seed, ClassHypothesis found,
                             double same_angle) {
  SymmetryLists lists =
      with_symmetries_of_class({seed.axes, seed.planes}, found.symmetry_class, same_angle);
  return {std::move(found.points), std::move(lists.rotational), std::move(lists.reflectional),
          seed.confidence};
}

}  // namespace

std::vector<MergedHypothesis> class_proposals(const Workspace& space,
                                              const std::vector<ProposalDraft>& drafts,
                                              const ProposalOptions& options) {
  const ClassSegmentationOptions& classes = options.class_segmentation;
  std::vector<std::optional<ClassHypothesis>> found = segment_classes(
      space.surface(), options.spacing, seeds_of(drafts, classes), options.classes, classes);
  std::vector<MergedHypothesis> kept;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (!found[k] ||
        found[k]->points.size() < static_cast<std::size_t>(options.surface_parts.min_size))
      continue;
    const PointIndices& points = found[k]->points;
    const auto repeats = [&](const MergedHypothesis& other) {
      return cover_same_points(other.points, points, classes.same_object);
    };
    if (std::any_of(drafts.begin(), drafts.end(),
                    [&](const ProposalDraft& draft) { return repeats(draft.merged); }) ||
        std::any_of(kept.begin(), kept.end(), repeats))
      continue;
    kept.push_back(merged_with(drafts[k].merged, std::move(*found[k]), options.merge.same_angle));
  }
  return kept;
}

}  // namespace symscene
