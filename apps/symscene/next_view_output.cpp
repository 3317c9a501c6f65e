#include "next_view_output.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "io/pose_json.hpp"
#include "io/view_json.hpp"

namespace symscene::app {
namespace {

constexpr std::size_t listed_views = 10;
constexpr std::size_t drawn_views = 200;    // on the page
constexpr double square_centimetres = 1e4;  // per m²

Json to_json(const RankedView& view, const Eigen::Isometry3d& pose) {
  return {{"candidate", view.candidate},
          {"gain", view.gain.total()},
          {"inferred", view.gain.inferred},
          {"disputed", view.gain.disputed},
          {"unknown", view.gain.unknown},
          {"cost", view.gain.cost},
          {"T_world_camera", pose_json(pose, "views to write")}};
}

bool counts_voxels(ViewPolicy policy) { return policy != ViewPolicy::symmetry; }

std::string row_of(std::size_t rank, const RankedView& view, ViewPolicy policy) {
  const ViewGain& gain = view.gain;
  if (counts_voxels(policy))
    return fmt::format("\n{:>4}  {:>9}  {:>9.0f}", rank, view.candidate, gain.total());
  const auto area = [](double value) { return square_centimetres * value; };
  return fmt::format("\n{:>4}  {:>9}  {:>9.1f}  {:>8.1f}  {:>8.1f}  {:>7.1f}  {:>5.1f}", rank,
                     view.candidate, area(gain.total()), area(gain.inferred), area(gain.disputed),
                     area(gain.unknown), area(gain.cost));
}

}  // namespace

std::string format_next_views_json(const RankedCandidates& ranked) {
  Json views = Json::array();
  for (const RankedView& view : ranked.views.ranked)
    views.push_back(to_json(view, ranked.poses[view.candidate]));
  const Json json = {{"version", 1},
                     {"policy", to_string(ranked.policy)},
                     {"gain_unit", counts_voxels(ranked.policy) ? "voxels" : "m2"},
                     {"is_enough", ranked.views.is_enough},
                     {"inferred_area_m2", ranked.views.inferred_area},
                     {"object_area_m2", ranked.views.object_area},
                     {"camera", camera_json(ranked.camera)},
                     {"views", std::move(views)},
                     {"timings", stage_times_json(ranked.views.timings)}};
  return json.dump(1) + "\n";
}

std::string format_next_views(const RankedCandidates& ranked) {
  if (ranked.views.ranked.empty()) {
    return ranked.views.unreachable == ranked.poses.size()
               ? fmt::format("no view: none of {} can be reached", ranked.poses.size())
               : "no view: the scene has no points that one could show more of";
  }
  std::string table = counts_voxels(ranked.policy)
                          ? "rank  candidate  voxels"
                          : "rank  candidate  gain cm2  inferred  disputed  unknown   cost";
  for (std::size_t k = 0; k < std::min(listed_views, ranked.views.ranked.size()); ++k)
    table += row_of(k + 1, ranked.views.ranked[k], ranked.policy);
  if (ranked.views.object_area > 0.0)
    table += fmt::format("\n{:.0f} % of the objects' surface is inferred, not seen",
                         100.0 * ranked.views.inferred_area / ranked.views.object_area);
  if (ranked.views.is_enough) table += "; no view is expected to show much more";
  return table;
}

PageViews page_views(const RankedCandidates& ranked) {
  const Eigen::Vector2d half = ranked.camera.half_size();
  PageViews page;
  page.policy = to_string(ranked.policy);
  page.unit = counts_voxels(ranked.policy) ? "voxels" : "cm²";
  const double scale = counts_voxels(ranked.policy) ? 1.0 : square_centimetres;
  page.half_width = half.x();
  page.half_height = half.y();
  page.is_enough = ranked.views.is_enough;
  for (const RankedView& view : ranked.views.ranked) {
    if (page.views.size() == drawn_views) break;
    page.views.push_back({view.candidate, ranked.poses[view.candidate], scale * view.gain.total(),
                          scale * view.gain.inferred, scale * view.gain.disputed,
                          scale * view.gain.unknown, scale * view.gain.cost});
  }
  return page;
}

}  // namespace symscene::app
