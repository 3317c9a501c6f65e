#include "symscene/view_planning/next_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"
#include "view_places.hpp"
#include "voxel_counts.hpp"

namespace symscene {
namespace {

constexpr std::array<const char*, 3> policy_names{"symmetry", "unknown-voxels", "rear-side-voxels"};

/// A camera at a candidate pose.
class Viewer {
 public:
  Viewer(const CameraIntrinsics& camera, const Eigen::Isometry3d& T_world_camera,
         const ViewSpace& space, const NextViewOptions& options)
      : camera_(camera),
        T_camera_world_(T_world_camera.inverse()),
        eye_(T_world_camera.translation().cast<float>()),
        space_(space),
        min_depth_(options.min_depth),
        max_depth_(options.max_depth),
        least_cosine_(static_cast<float>(std::cos(options.max_incidence))) {}

  /// The worth of the places that the camera would see.
  double worth(const std::vector<ViewPlace>& places) const {
    double sum = 0.0;
    for (const ViewPlace& place : places) {
      if (faces(place) && is_in_image(place) && space_.sees(eye_, place.position))
        sum += place.worth;
    }
    return sum;
  }

 private:
  bool faces(const ViewPlace& place) const {
    if (place.normal.isZero()) return true;
    return place.normal.dot((eye_ - place.position).normalized()) >= least_cosine_;
  }
  bool is_in_image(const ViewPlace& place) const {
    const Eigen::Vector3d at = T_camera_world_ * place.position.cast<double>();
    if (!(at.z() > 0.0) || at.z() < min_depth_ || at.z() > max_depth_) return false;
    const Eigen::Vector2d pixel = camera_.project(at);
    return pixel.x() >= -0.5 && pixel.x() < static_cast<double>(camera_.width) - 0.5 &&
           pixel.y() >= -0.5 && pixel.y() < static_cast<double>(camera_.height) - 0.5;
  }

  const CameraIntrinsics& camera_;
  Eigen::Isometry3d T_camera_world_;
  Eigen::Vector3f eye_;
  const ViewSpace& space_;
  double min_depth_, max_depth_;  ///< [m]
  float least_cosine_;
};

ViewGain counted_gain(const ViewSpace& space, const CameraIntrinsics& camera,
                      const Eigen::Isometry3d& pose, const NextViewOptions& options,
                      ViewPolicy policy) {
  const VoxelCounts counts = count_unknown(space, camera, pose, options.ray_columns);
  ViewGain gain;
  gain.unknown =
      static_cast<double>(policy == ViewPolicy::unknown_voxels ? counts.unknown : counts.rear_side);
  return gain;
}

ViewGain gain_of(const ViewSpace& space, const ViewPlaces& places, const CameraIntrinsics& camera,
                 const Eigen::Isometry3d& pose, const NextViewOptions& options, ViewPolicy policy) {
  if (!space.can_hold_camera(pose.translation().cast<float>())) return {};
  if (policy != ViewPolicy::symmetry) return counted_gain(space, camera, pose, options, policy);
  const Viewer viewer(camera, pose, space, options);
  return {viewer.worth(places.inferred), viewer.worth(places.disputed),
          viewer.worth(places.unknown), 0.0};
}

void require_consistent(const SegmentationResult& result) {
  const std::size_t objects = result.objects.size();
  for (const std::size_t count : {result.surfaces.size(), result.completed.size()}) {
    if (count != 0 && count != objects)
      throw InputError("the result", fmt::format("{} surfaces and completions, or none", objects),
                       fmt::format("{}", count));
  }
}

/// Farther away coordinates have no precision, and nothing is seen.
void require_near(std::span<const Eigen::Isometry3d> candidates, const PointCloud& cloud) {
  constexpr double farthest = 1000.0;  // [m]
  const Eigen::Vector3d scene = cloud.position(0).cast<double>();
  for (const Eigen::Isometry3d& pose : candidates) {
    if (!pose.matrix().allFinite() || !((pose.translation() - scene).norm() < farthest))
      throw InputError("candidates", "finite poses within 1 km of the scene", "another");
  }
}

/// Those that can be reached.
std::vector<RankedView> reachable(std::size_t candidates, std::span<const double> costs) {
  std::vector<RankedView> views;
  for (std::size_t i = 0; i < candidates; ++i) {
    if (costs.empty() || std::isfinite(costs[i])) views.push_back({i, {}});
  }
  return views;
}

void sort_by_gain(std::vector<RankedView>& ranked) {
  std::stable_sort(ranked.begin(), ranked.end(), [](const RankedView& a, const RankedView& b) {
    return a.gain.total() > b.gain.total();
  });
}

}  // namespace

const char* to_string(ViewPolicy policy) {
  return policy_names.at(static_cast<std::size_t>(policy));
}

ViewPolicy view_policy(std::string_view name) {
  for (std::size_t i = 0; i < policy_names.size(); ++i) {
    if (name == policy_names[i]) return static_cast<ViewPolicy>(i);
  }
  throw InputError("policy", "symmetry, unknown-voxels or rear-side-voxels",
                   fmt::format("\"{}\"", name));
}

NextViews rank_views(const KnownScene& scene, const CameraIntrinsics& camera,
                     std::span<const Eigen::Isometry3d> candidates, const NextViewOptions& options,
                     ViewPolicy policy, std::span<const double> costs) {
  options.validate();
  if (!costs.empty() && costs.size() != candidates.size())
    throw InputError("costs", fmt::format("{}, one per candidate", candidates.size()),
                     fmt::format("{}", costs.size()));
  if (policy != ViewPolicy::symmetry && scene.occupancy == nullptr)
    throw InputError("policy", fmt::format("occupancy for {}", to_string(policy)), "none");
  StageTimer timer;
  NextViews views;
  views.ranked = reachable(candidates.size(), costs);
  views.unreachable = candidates.size() - views.ranked.size();
  if (scene.result.cloud.empty()) {
    views.ranked.clear();
    views.is_enough = true;
    return views;
  }
  require_consistent(scene.result);
  require_near(candidates, scene.result.cloud);
  const ViewSpace space = timer.time("space", [&] { return ViewSpace(scene, options); });
  ViewPlaces places = timer.time("places", [&] { return view_places(scene, space, options); });
  views.inferred_area = places.inferred_area;
  views.object_area = places.object_area;
  views.unknown_area = places.unknown_area;
  views.areas = std::move(places.areas);
  timer.time("gains", [&] {
    parallel_for_each(views.ranked.size(), [&](std::size_t k) {
      RankedView& view = views.ranked[k];
      view.gain = gain_of(space, places, camera, candidates[view.candidate], options, policy);
      if (!costs.empty()) view.gain.cost = options.cost_weight * costs[view.candidate];
    });
  });
  sort_by_gain(views.ranked);
  views.is_enough = views.ranked.empty() ||
                    (policy == ViewPolicy::symmetry &&
                     views.ranked.front().gain.total() < options.min_share * views.object_area);
  views.timings = timer.stages();
  return views;
}

}  // namespace symscene
