#include "symscene/stitching/stitching.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "pair_pose.hpp"
#include "pose_graph.hpp"
#include "sweep_gaps.hpp"
#include "view_alignment.hpp"

namespace symscene {
namespace {

constexpr int fewest_features = 6;  ///< that determine a pose

/// A prepared frame.
struct View {
  Measurement measurement;
  FrameFeatures features;

  /// The surface against which the pose of a pair is checked; a coarse one suffices.
  const SurfaceImage& checked_surface() const {
    return measurement.pyramid[measurement.pyramid.size() > 1 ? 1 : 0];
  }
};

/// Whether frames without features are refused.
enum class Features { required, optional };

std::vector<View> prepare_views(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                                const StitchingOptions& options, Features need) {
  std::vector<View> views(frames.size());
  parallel_for_each(frames.size(), [&](std::size_t i) {
    views[i].measurement = prepare_measurement(frames[i], camera, options.measurement);
    const bool possible = has_feature_matcher() && frames[i].colors.rows() > 0;
    if (need == Features::optional && !possible) return;
    views[i].features = find_features(frames[i], camera, options.features, options.measurement);
  });
  return views;
}

std::vector<StitchedPair> compare_all(std::span<const View> views, const CameraIntrinsics& camera,
                                      const StitchingOptions& options) {
  std::vector<StitchedPair> pairs;
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t j = i + 1; j < views.size(); ++j) pairs.push_back({i, j, {}});
  }
  parallel_for_each(pairs.size(), [&](std::size_t k) {
    const View& first = views[pairs[k].first];
    const View& second = views[pairs[k].second];
    pairs[k].pose = find_pair_pose({first.features, first.checked_surface()},
                                   {second.features, second.checked_surface()}, camera, options);
  });
  return pairs;
}

std::vector<std::optional<Eigen::Isometry3d>> chained(std::size_t frames,
                                                      std::span<const StitchedPair> pairs) {
  std::vector<PoseEdge> edges;
  for (const StitchedPair& pair : pairs) {
    if (!is_joined(pair.pose.status)) continue;
    edges.push_back({pair.first, pair.second, pair.pose.T_first_second,
                     static_cast<double>(pair.pose.inliers.size())});
  }
  if (edges.empty()) return std::vector<std::optional<Eigen::Isometry3d>>(frames);
  return chain_poses(frames, edges);
}

std::vector<const Measurement*> measurements_of(std::span<const View> views) {
  std::vector<const Measurement*> measurements;
  for (const View& view : views) measurements.push_back(&view.measurement);
  return measurements;
}

/// The frames with poses, as the alignment takes them.
struct PlacedViews {
  std::vector<std::size_t> frames;
  std::vector<Measurement> views;
  std::vector<Eigen::Isometry3d> poses;
  std::vector<PointPairs> points;
};

/// The points of the features of accepted pairs; views are numbered among the placed frames.
std::vector<PointPairs> shared_points_of(std::span<const View> views,
                                         std::span<const StitchedPair> pairs,
                                         std::span<const std::size_t> place_of) {
  std::vector<PointPairs> shared;
  for (const StitchedPair& pair : pairs) {
    if (pair.pose.status != PairStatus::accepted) continue;
    const std::size_t first = place_of[pair.first], second = place_of[pair.second];
    if (first == views.size() || second == views.size()) continue;
    const auto count = static_cast<Eigen::Index>(pair.pose.inliers.size());
    PointPairs points{first, second, Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
    for (Eigen::Index k = 0; k < count; ++k) {
      const FeatureMatch& match = pair.pose.inliers[static_cast<std::size_t>(k)];
      points.points_first.col(k) = views[pair.first].features.points_camera.col(match.first);
      points.points_second.col(k) = views[pair.second].features.points_camera.col(match.second);
    }
    shared.push_back(std::move(points));
  }
  return shared;
}

PlacedViews place(std::span<View> views, std::span<const StitchedPair> pairs,
                  std::span<const std::optional<Eigen::Isometry3d>> poses) {
  PlacedViews placed;
  std::vector<std::size_t> place_of(views.size(), views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!poses[i]) continue;
    place_of[i] = placed.frames.size();
    placed.frames.push_back(i);
    placed.poses.push_back(*poses[i]);
    placed.views.push_back(std::move(views[i].measurement));
  }
  placed.points = shared_points_of(views, pairs, place_of);
  return placed;
}

const char* reason_for(const View& view, std::size_t placed, const StitchingOptions& options) {
  if (view.features.size() < static_cast<std::size_t>(options.pairs.min_inliers)) {
    return "too little texture where depth is known";
  }
  return placed > 0 ? "no surface in common with the other frames"
                    : "no two frames show the same surface";
}

/// Poses of pairs from few features.
PoseOfPair loose_poses(std::span<const View> views, const CameraIntrinsics& camera,
                       StitchingOptions options) {
  options.pairs.min_inliers = std::min(options.pairs.min_inliers, fewest_features);
  return [=](std::size_t i, std::size_t j) -> std::optional<Eigen::Isometry3d> {
    const PairPose pose =
        find_pair_pose({views[i].features, views[i].checked_surface()},
                       {views[j].features, views[j].checked_surface()}, camera, options);
    const auto least = static_cast<std::size_t>(fewest_features);
    return pose.inliers.size() >= least ? std::optional(pose.T_first_second) : std::nullopt;
  };
}

/// `close` may join further pairs, for which frames need no features.
template <class Close>
StitchingResult stitch(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                       const StitchingOptions& options, Features need, const Close& close) {
  options.validate();
  StageTimer timer;
  StitchingResult result;
  std::vector<View> views =
      timer.time("features", [&] { return prepare_views(frames, camera, options, need); });
  result.pairs = timer.time("pairs", [&] { return compare_all(views, camera, options); });
  timer.time("gaps", [&] { close(views, result.pairs); });
  const PlacedViews placed = place(views, result.pairs, chained(frames.size(), result.pairs));
  const ViewAlignment aligned = timer.time("align", [&] {
    return align_views(placed.views, placed.poses, placed.points, options.alignment,
                       options.measurement);
  });

  result.placed = placed.frames.size();
  result.converged = aligned.converged;
  result.frames.resize(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    result.frames[i].features = views[i].features.size();
    result.frames[i].reason = reason_for(views[i], result.placed, options);
  }
  for (std::size_t k = 0; k < placed.frames.size(); ++k) {
    StitchedFrame& frame = result.frames[placed.frames[k]];
    frame.T_world_camera = aligned.T_world_camera[k];
    frame.fit = aligned.fits[k];
    frame.reason = "";
  }
  result.times = timer.stages();
  return result;
}

}  // namespace

StitchingResult stitch_frames(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                              const StitchingOptions& options) {
  return stitch(frames, camera, options, Features::required, [](const auto&, const auto&) {});
}

StitchingResult stitch_sweep(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                             const StitchingOptions& options, const TrackingOptions& tracking) {
  const auto close = [&](std::span<const View> views, std::vector<StitchedPair>& pairs) {
    close_gaps(measurements_of(views), options, tracking, loose_poses(views, camera, options),
               pairs);
  };
  return stitch(frames, camera, options, Features::optional, close);
}

}  // namespace symscene
