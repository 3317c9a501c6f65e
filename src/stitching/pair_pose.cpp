#include "symscene/stitching/pair_pose.hpp"

#include <algorithm>
#include <cmath>

#include "image_features.hpp"
#include "reprojection.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

SharedPoints shared_points(const ImageFeatures& first, const ImageFeatures& second,
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

/// A pose by PnP and the matches that led to it.
struct Candidate {
  Eigen::Isometry3d T_first_second = Eigen::Isometry3d::Identity();
  std::vector<Index> inliers;
};

/// The points of either frame in the other's image; what more matches agree with.
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

/// The worse of the two directions.
DepthAgreement mutual_agreement(const SurfaceImage& first, const SurfaceImage& second,
                                const Eigen::Isometry3d& T_first_second, double tolerance,
                                const MeasurementOptions& sensor) {
  const DepthAgreement there = depth_agreement(second, first, T_first_second, tolerance, sensor);
  const DepthAgreement back =
      depth_agreement(first, second, T_first_second.inverse(), tolerance, sensor);
  return {std::min(there.overlap, back.overlap), std::min(there.agreement, back.agreement)};
}

}  // namespace

void PairOptions::validate() const {
  require_option(reprojection > 0, "reprojection", "a positive number", reprojection);
  require_option(iterations >= 10 && iterations <= 1000000, "iterations", "10 to 1,000,000",
                 iterations);
  require_option(min_inliers >= 6, "min_inliers", "at least 6", min_inliers);
  require_option(max_gap > 0, "max_gap", "a positive number", max_gap);
  require_option(tolerance > 0, "tolerance", "a positive number", tolerance);
  require_option(min_overlap > 0 && min_overlap <= 1, "min_overlap", "a share in (0, 1]",
                 min_overlap);
  require_option(min_agreement >= 0 && min_agreement <= 1, "min_agreement", "a share in [0, 1]",
                 min_agreement);
}

const char* to_string(PairStatus status) {
  switch (status) {
    case PairStatus::accepted:
      return "accepted";
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

PairPose find_pair_pose(const ImageFeatures& first, const ImageFeatures& second,
                        const SurfaceImage& first_surface, const SurfaceImage& second_surface,
                        const CameraIntrinsics& camera, const FeatureOptions& matching,
                        const PairOptions& options, const MeasurementOptions& sensor) {
  const auto enough = static_cast<std::size_t>(options.min_inliers);
  PairPose pair;
  const std::vector<FeatureMatch> matches = match_features(first, second, matching);
  pair.matches = matches.size();
  if (matches.size() < enough) return pair;

  pair.status = PairStatus::few_inliers;
  const SharedPoints shared = shared_points(first, second, matches);
  const Candidate start = solve_both_ways(shared, camera, options);
  if (start.inliers.size() < enough) return pair;
  const auto on = [&](std::span<const Index> inliers) {
    return shared_points(first, second, select(matches, inliers));
  };
  // The second time on the matches that the better pose brings in.
  const double scale = options.reprojection / 2.0;
  pair.T_first_second =
      refine_by_reprojection(on(start.inliers), camera, start.T_first_second, scale);
  std::vector<Index> inliers = agreeing(shared, camera, pair.T_first_second, options);
  if (inliers.size() >= enough) {
    pair.T_first_second = refine_by_reprojection(on(inliers), camera, pair.T_first_second, scale);
    inliers = agreeing(shared, camera, pair.T_first_second, options);
  }
  pair.inliers = select(matches, inliers);
  if (inliers.size() < enough) return pair;

  pair.depth = mutual_agreement(first_surface, second_surface, pair.T_first_second,
                                options.tolerance, sensor);
  pair.status = pair.depth.overlap < options.min_overlap       ? PairStatus::little_shown
                : pair.depth.agreement < options.min_agreement ? PairStatus::contradicted
                                                               : PairStatus::accepted;
  return pair;
}

}  // namespace symscene
