#include "pair_pose.hpp"

#include <algorithm>
#include <cmath>

#include "image_features.hpp"
#include "reconstruction/pose_fit.hpp"
#include "reprojection.hpp"

namespace symscene {
namespace {

SharedPoints shared_points(const FrameFeatures& first, const FrameFeatures& second,
                           std::span<const FeatureMatch> matches) {
  const auto count = static_cast<Eigen::Index>(matches.size());
  SharedPoints shared{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count),
                      Eigen::Matrix2Xd(2, count), Eigen::Matrix2Xd(2, count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const FeatureMatch& match = matches[static_cast<std::size_t>(k)];
    shared.points_first.col(k) = first.points_camera.col(match.first);
    shared.points_second.col(k) = second.points_camera.col(match.second);
    shared.pixels_first.col(k) = first.pixels.col(match.first);
    shared.pixels_second.col(k) = second.pixels.col(match.second);
  }
  return shared;
}

/// A pose by PnP and its inliers.
struct Candidate {
  Eigen::Isometry3d T_first_second = Eigen::Isometry3d::Identity();
  std::vector<Index> inliers;
};

/// PnP with the points of either frame in the other's image; the result with more inliers.
Candidate solve_both_ways(const SharedPoints& shared, const CameraIntrinsics& camera,
                          const PairOptions& options) {
  Candidate best;
  if (auto seen = solve_perspective(shared.points_first, shared.pixels_second, camera, options)) {
    best = {seen->T_camera_points.inverse(), std::move(seen->inliers)};
  }
  auto seen = solve_perspective(shared.points_second, shared.pixels_first, camera, options);
  if (seen && seen->inliers.size() > best.inliers.size()) {
    best = {seen->T_camera_points, std::move(seen->inliers)};
  }
  return best;
}

std::vector<FeatureMatch> select(std::span<const FeatureMatch> matches,
                                 std::span<const Index> indices) {
  std::vector<FeatureMatch> selected;
  for (const Index k : indices) selected.push_back(matches[k]);
  return selected;
}

/// The matches that agree with a pose in both images and in space.
std::vector<Index> agreeing(const SharedPoints& shared, const CameraIntrinsics& camera,
                            const Eigen::Isometry3d& T_first_second, const PairOptions& options) {
  std::vector<Index> inliers;
  for (Eigen::Index k = 0; k < shared.points_first.cols(); ++k) {
    const Eigen::Vector3d p = shared.points_first.col(k);
    const double gap = (T_first_second * shared.points_second.col(k) - p).norm();
    if (!(error_in_first(shared, k, camera, T_first_second).norm() <= options.reprojection) ||
        !(error_in_second(shared, k, camera, T_first_second).norm() <= options.reprojection) ||
        !(gap <= options.max_gap * std::max(1.0, p.z() * p.z()))) {
      continue;
    }
    inliers.push_back(static_cast<Index>(k));
  }
  return inliers;
}

}  // namespace

const char* to_string(PairStatus status) {
  switch (status) {
    case PairStatus::accepted:
      return "accepted";
    case PairStatus::tracked:
      return "tracked";
    case PairStatus::few_matches:
      return "too few matches";
    case PairStatus::few_inliers:
      return "too few matches agree";
    case PairStatus::little_shown:
      return "too little overlap";
    case PairStatus::contradicted:
      return "contradicted by depth";
  }
  return "";
}

DepthAgreement mutual_agreement(const SurfaceImage& first, const SurfaceImage& second,
                                const Eigen::Isometry3d& T_first_second, const DepthNoise& noise) {
  const PoseFit there = depth_fit(second, first, T_first_second, noise);
  const PoseFit back = depth_fit(first, second, T_first_second.inverse(), noise);
  return {std::min(there.overlap(), back.overlap()), std::min(there.agreement(), back.agreement())};
}

DepthAgreement mutual_agreement(const SurfaceImage& first, const SurfaceImage& second,
                                const Eigen::Isometry3d& T_first_second,
                                const StitchingOptions& options) {
  const DepthNoise noise{.floor = static_cast<float>(options.pairs.tolerance) / inlier_sigmas,
                         .moved = 0.0F,
                         .fixed = static_cast<float>(options.measurement.noise)};
  return mutual_agreement(first, second, T_first_second, noise);
}

PairStatus status_of(const DepthAgreement& depth, const PairOptions& options) {
  if (depth.overlap < options.min_overlap) return PairStatus::little_shown;
  if (depth.agreement < options.min_agreement) return PairStatus::contradicted;
  return PairStatus::accepted;
}

PairPose find_pair_pose(const PairView& first, const PairView& second,
                        const CameraIntrinsics& camera, const StitchingOptions& options) {
  const auto enough = static_cast<std::size_t>(options.pairs.min_inliers);
  PairPose pair;
  const std::vector<FeatureMatch> matches =
      match_features(first.features, second.features, options.features);
  pair.matches = matches.size();
  if (matches.size() < enough) return pair;

  pair.status = PairStatus::few_inliers;
  const SharedPoints shared = shared_points(first.features, second.features, matches);
  const Candidate start = solve_both_ways(shared, camera, options.pairs);
  if (start.inliers.size() < enough) return pair;
  const double scale = options.pairs.reprojection / 2.0;
  const auto refine = [&](std::span<const Index> inliers, const Eigen::Isometry3d& from) {
    const auto used = shared_points(first.features, second.features, select(matches, inliers));
    pair.T_first_second = refine_by_reprojection(used, camera, from, scale);
    return agreeing(shared, camera, pair.T_first_second, options.pairs);
  };
  std::vector<Index> inliers = refine(start.inliers, start.T_first_second);
  // Again with the matches that agree with the better pose.
  if (inliers.size() >= enough) inliers = refine(inliers, pair.T_first_second);
  pair.inliers = select(matches, inliers);
  if (inliers.size() < enough) return pair;

  pair.depth = mutual_agreement(first.surface, second.surface, pair.T_first_second, options);
  pair.status = status_of(pair.depth, options.pairs);
  return pair;
}

}  // namespace symscene
