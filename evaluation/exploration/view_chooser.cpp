#include "view_chooser.hpp"

#include <algorithm>
#include <limits>
#include <utility>

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
      visited_(candidates.size(), 0) {}

ViewChoice ViewChooser::next(const ExploredScene& known) {
  if (std::find(visited_.begin(), visited_.end(), 0) == visited_.end()) return {};
  NextViews views;
  if (const auto policy = ranking_policy(policy_)) views = ranked(known, *policy);
  const std::size_t view = chosen(known, views);
  return {view, std::move(views)};
}

NextViews ViewChooser::ranked(const ExploredScene& known, ViewPolicy policy) const {
  if (!known.scene.occupancy || known.result.cloud.empty()) return {};
  std::vector<double> costs(visited_.size(), 0.0);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (visited_[i] != 0) costs[i] = std::numeric_limits<double>::infinity();
  }
  return rank_views({known.result, &*known.scene.occupancy}, clutter_camera(), candidates_,
                    options_, policy, costs);
}

/// Where nothing is known yet, a policy that ranks goes along the arc.
std::size_t ViewChooser::chosen(const ExploredScene& known, const NextViews& views) {
  if (!views.ranked.empty()) return views.ranked.front().candidate;
  switch (policy_) {
    case ExplorationPolicy::random:
      return drawn();
    case ExplorationPolicy::oracle:
      return most_unseen(known);
    default:
      return along_arc();
  }
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
