#include "view_chooser.hpp"

#include <algorithm>
#include <array>

#include "core/parallel.hpp"
#include "symscene/clutter/clutter_views.hpp"

namespace symscene {

ViewChooser::ViewChooser(ExplorationPolicy policy, std::span<const Eigen::Isometry3d> candidates,
                         std::size_t first, const NextViewOptions& options, Random random)
    : policy_(policy),
      candidates_(candidates),
      first_(first),
      options_(options),
      random_(random),
      visited_(candidates.size(), 0) {
  visited_[first] = 1;
}

std::optional<std::size_t> ViewChooser::next(const ExploredScene& known) {
  if (std::find(visited_.begin(), visited_.end(), 0) == visited_.end()) return std::nullopt;
  const std::size_t view = chosen(known);
  visited_[view] = 1;
  return view;
}

std::size_t ViewChooser::chosen(const ExploredScene& known) {
  switch (policy_) {
    case ExplorationPolicy::symmetry:
      return ranked(known, ViewPolicy::symmetry);
    case ExplorationPolicy::unknown_voxels:
      return ranked(known, ViewPolicy::unknown_voxels);
    case ExplorationPolicy::rear_side_voxels:
      return ranked(known, ViewPolicy::rear_side_voxels);
    case ExplorationPolicy::fixed_arc:
      return along_arc();
    case ExplorationPolicy::random:
      return drawn();
    case ExplorationPolicy::oracle:
      break;
  }
  return most_unseen(known);
}

/// Where nothing is known yet, the arc goes on.
std::size_t ViewChooser::ranked(const ExploredScene& known, ViewPolicy policy) const {
  if (!known.scene.occupancy || known.result.cloud.empty()) return along_arc();
  const NextViews views = rank_views({known.result, &*known.scene.occupancy}, clutter_camera(),
                                     candidates_, options_, policy);
  for (const RankedView& view : views.ranked) {
    if (visited_[view.candidate] == 0) return view.candidate;
  }
  return along_arc();
}

std::size_t ViewChooser::along_arc() const {
  std::size_t view = first_;
  while (visited_[view] != 0) view = (view + 1) % visited_.size();
  return view;
}

std::size_t ViewChooser::drawn() {
  for (;;) {
    const std::size_t view = random_.below(static_cast<std::uint32_t>(visited_.size()));
    if (visited_[view] == 0) return view;
  }
}

std::size_t ViewChooser::most_unseen(const ExploredScene& known) const {
  const CameraIntrinsics camera = small_clutter_camera();
  const PointIndices unseen = known.truth.uncovered(known.scene.cloud.positions);
  std::vector<std::size_t> gains(candidates_.size(), 0);
  parallel_for_each(candidates_.size(), [&](std::size_t i) {
    if (visited_[i] == 0) gains[i] = 1 + known.truth.count_visible(unseen, camera, candidates_[i]);
  });
  return static_cast<std::size_t>(std::max_element(gains.begin(), gains.end()) - gains.begin());
}

}  // namespace symscene
