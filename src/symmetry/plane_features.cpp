#include "symmetry/plane_features.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sphere_fit.hpp"

namespace symscene {
namespace {

constexpr float cell_size = 0.01F;

/// The factor by which the spacing of surface points grows when they are subsampled.
float spacing_growth(Index points, int max_points) {
  return std::sqrt(std::max(1.0F, static_cast<float>(points) / static_cast<float>(max_points)));
}

/// The features that compare a plane with those of lower residual.
void compare(const MatchedPlane& own, std::span<const MatchedPlane> better, PlaneFeatures& m) {
  m.rank = static_cast<double>(better.size());
  m.nearest = 0.5 * std::numbers::pi;
  m.off_square = better.empty() ? -1.0 : 1.0;
  m.best_matched = better.empty() ? own.images.matched : better.front().images.matched;
  for (const MatchedPlane& other : better) {
    const double angle = line_angle(own.plane.normal, other.plane.normal);
    m.nearest = std::min(m.nearest, angle);
    m.off_square = std::min(m.off_square, std::cos(angle));
  }
}

}  // namespace

PlaneFeatureExtractor::PlaneFeatureExtractor(const PointCloud& points, const DistanceField& field,
                                             const std::optional<Plane>& table,
                                             const PlaneFeatureOptions& options)
    : points_(points),
      field_(field),
      table_(table),
      options_(options),
      cells_(points.positions, cell_size),
      sample_(evenly_spread(points.size(), static_cast<Index>(options.max_points))),
      neighbor_sample_(
          evenly_spread(points.size(), static_cast<Index>(options.max_neighbor_points))),
      shell_(select(points,
                    evenly_spread(points.size(), static_cast<Index>(options.max_shell_points)))),
      shell_gap_(static_cast<float>(options.shell_gap) *
                 spacing_growth(points.size(), options.max_shell_points)),
      centroid_(centroid(points.positions)),
      roundness_(distance_off_sphere(points.positions)) {
  const Eigen::Matrix3f axes = principal_axes(points.positions).cast<float>();
  const Points along = points.positions * axes;
  const Eigen::Vector3d extents =
      (along.colwise().maxCoeff() - along.colwise().minCoeff()).transpose().cast<double>();
  length_ = extents.maxCoeff();
  thickness_ = extents.minCoeff();
}

PlaneFeatures PlaneFeatureExtractor::features(const MatchedPlane& matched,
                                              const PlaneContext& context) const {
  const ReflectionPlane& plane = matched.plane;
  const Eigen::Vector3f normal = plane.normal.cast<float>();
  const Eigen::VectorXf facing = (points_.normals * normal).cwiseAbs();
  const Eigen::VectorXf heights =
      points_.positions * normal -
      Eigen::VectorXf::Constant(points_.positions.rows(),
                                static_cast<float>(plane.normal.dot(plane.point)));
  const auto count = static_cast<double>(points_.size());
  const auto share = [&](const auto& mask) { return static_cast<double>(mask.count()) / count; };
  PlaneFeatures m;
  m.images = matched.images;
  m.near = share(heights.array().abs() < static_cast<float>(options_.min_plane_distance));
  const double positive = share(heights.array() > 0.0F);
  m.balance = std::min(positive, 1.0 - positive);
  m.across = share(facing.array() < static_cast<float>(options_.max_across_cosine));
  m.facing = share(facing.array() > static_cast<float>(options_.min_facing_cosine));
  m.extent = static_cast<double>(heights.maxCoeff() - heights.minCoeff());
  m.tilted = share_matched_tilted(plane);
  m.shifted = share_matched_shifted(plane, options_.shift * m.extent);
  m.length = length_;
  m.thickness = thickness_;
  m.size = std::log(count);
  m.roundness = roundness_;
  m.upright = table_ ? std::abs(table_->normal.dot(plane.normal)) : -1.0;
  m.along_axis = context.axis ? std::abs(context.axis->direction.dot(plane.normal)) : -1.0;
  m.object_score = context.object_score;
  compare(matched, context.better, m);
  return m;
}

double PlaneFeatureExtractor::share_matched_tilted(const ReflectionPlane& plane) const {
  const Eigen::Vector3d here = plane.project(centroid_);
  const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(plane.normal);
  const double tilt = std::tan(options_.tilt);
  double greatest = 0.0;
  for (const double sign : {-1.0, 1.0}) {
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector3d tilted = (plane.normal + sign * tilt * basis.col(k)).normalized();
      greatest = std::max(greatest, share_matched({here, tilted}));
    }
  }
  return greatest;
}

double PlaneFeatureExtractor::share_matched_shifted(const ReflectionPlane& plane,
                                                    double distance) const {
  const Eigen::Vector3d here = plane.project(centroid_);
  double greatest = 0.0;
  for (const double sign : {-1.0, 1.0}) {
    const Eigen::Vector3d shifted = here + sign * distance * plane.normal;
    greatest = std::max(greatest, share_matched({shifted, plane.normal}));
  }
  return greatest;
}

ImageFeatures PlaneFeatureExtractor::images_of(const ReflectionPlane& plane) const {
  const PlaneReflector reflector(plane);
  const Eigen::Vector3f across = plane.normal.cast<float>();
  const auto min_empty = static_cast<float>(options_.min_empty_distance);
  const auto max_exact_offset = static_cast<float>(options_.max_exact_offset);
  const auto min_exact_cosine = static_cast<float>(options_.min_exact_cosine);
  const auto min_steep_cosine = static_cast<float>(options_.min_steep_cosine);
  ImageFeatures m;
  double count = 0.0, steep = 0.0;
  for (const Index i : sample_) {
    if (matches_itself(reflector, i)) continue;
    count += 1.0;
    const Eigen::Vector3f p = reflector.point(points_.position(i));
    const Eigen::Vector3f n = reflector.direction(points_.normal(i));
    const bool is_steep = std::abs(points_.normal(i).dot(across)) > min_steep_cosine;
    steep += is_steep ? 1.0 : 0.0;
    const Image image = matched_image(p, n);
    if (image.match == Match::agrees) {
      m.matched += 1.0;
      m.residual += double{image.offset};
      m.turn += double{safe_acos(image.cosine)};
      m.exact += image.offset < max_exact_offset && image.cosine > min_exact_cosine ? 1.0 : 0.0;
      m.steep_matched += is_steep ? 1.0 : 0.0;
    } else if (image.match == Match::disagrees) {
      m.off_surface += 1.0;
    } else if (field_.at(p) > min_empty) {
      m.empty += 1.0;
    } else if (is_buried(p, n)) {
      m.buried += 1.0;
    }
  }
  if (m.matched > 0.0) {
    m.residual /= m.matched;
    m.turn /= m.matched;
  }
  if (steep > 0.0) m.steep_matched /= steep;
  for (double* share : {&m.matched, &m.off_surface, &m.empty, &m.buried, &m.exact})
    *share = count > 0.0 ? *share / count : 0.0;
  return m;
}

bool PlaneFeatureExtractor::matches_itself(const PlaneReflector& reflector, Index i) const {
  return std::abs(reflector.signed_distance(points_.position(i))) <
         static_cast<float>(options_.min_plane_distance);
}

PlaneFeatureExtractor::Image PlaneFeatureExtractor::matched_image(const Eigen::Vector3f& p,
                                                                  const Eigen::Vector3f& n) const {
  const auto min_cosine = static_cast<float>(std::cos(options_.max_image_angle));
  const auto max_offset = static_cast<float>(options_.max_image_offset);
  const auto max_distance = static_cast<float>(options_.max_image_distance);
  const auto disagree = static_cast<float>(options_.disagree_distance);
  Image best;
  best.offset = max_offset;
  cells_.for_each_within(p, max_distance, [&](Index j, float squared_distance) {
    const Eigen::Vector3f m = points_.normal(j);
    const float offset = std::abs(m.dot(p - points_.position(j)));
    if (m.dot(n) > min_cosine && offset < best.offset) {
      best = {Match::agrees, offset, m.dot(n)};
    } else if (best.match == Match::none && squared_distance < disagree * disagree) {
      best.match = Match::disagrees;
    }
  });
  return best;
}

/// Whether it lies behind a part of the surface that faces the same way.
bool PlaneFeatureExtractor::is_buried(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const {
  const auto min_depth = static_cast<float>(options_.min_depth);
  const auto max_depth = static_cast<float>(options_.max_depth);
  const auto min_cosine = static_cast<float>(options_.min_shell_cosine);
  for (Index k = 0; k < shell_.size(); ++k) {
    const Eigen::Vector3f to = shell_.position(k) - p;
    const float depth = to.dot(n);
    if (depth < min_depth || depth > max_depth || shell_.normal(k).dot(n) < min_cosine) continue;
    if (to.squaredNorm() - depth * depth < shell_gap_ * shell_gap_) return true;
  }
  return false;
}

double PlaneFeatureExtractor::share_matched(const ReflectionPlane& plane) const {
  const PlaneReflector reflector(plane);
  double matched = 0.0, count = 0.0;
  for (const Index i : neighbor_sample_) {
    if (matches_itself(reflector, i)) continue;
    count += 1.0;
    const Image image =
        matched_image(reflector.point(points_.position(i)), reflector.direction(points_.normal(i)));
    matched += image.match == Match::agrees ? 1.0 : 0.0;
  }
  return count > 0.0 ? matched / count : 0.0;
}

}  // namespace symscene
