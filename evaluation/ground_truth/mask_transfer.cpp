#include "symscene/ground_truth/mask_transfer.hpp"

#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

/// For each point of the labelled cloud the first true object that holds it.
std::vector<Index> labels_of(const PointCloud& labeled, const SceneTruth& truth) {
  std::vector<Index> labels(labeled.size(), CellList::none);
  for (std::size_t k = truth.objects.size(); k-- > 0;) {
    for (const Index i : truth.objects[k].points) {
      if (i >= labels.size()) {
        throw InputError("ground truth of " + truth.objects[k].name,
                         "indices below " + std::to_string(labels.size()), std::to_string(i));
      }
      labels[i] = static_cast<Index>(k);
    }
  }
  return labels;
}

}  // namespace

std::vector<PointIndices> transfer_masks(const PointCloud& labeled, const SceneTruth& truth,
                                         const PointCloud& target, float radius) {
  std::vector<PointIndices> masks(truth.objects.size());
  const std::vector<Index> labels = labels_of(labeled, truth);
  const CellList cells(labeled.positions, radius);
  for (Index i = 0; i < target.size(); ++i) {
    const Index nearest = cells.nearest(target.position(i), radius).first;
    if (nearest == CellList::none || labels[nearest] == CellList::none) continue;
    masks[labels[nearest]].push_back(i);
  }
  return masks;
}

}  // namespace symscene
