#include "symmetry/plane_features.hpp"

#include <algorithm>
#include <cmath>

#include "sphere_fit.hpp"

namespace symscene {
namespace {

constexpr float cell_size = 0.01F;
constexpr Index images_count = 300, thin_images = 120;
constexpr Index shell_points = 400;
constexpr float empty_space = 0.01F;  // into space that was seen empty [m]
constexpr float agree = 0.008F;       // between an image and the point that it meets [m]
constexpr float disagree = 0.005F;    // so near, an image has to agree [m]
constexpr float exact_offset = 0.001F;
constexpr float exact_cosine = 0.985F;
constexpr float across_cosine = 0.17F, facing_cosine = 0.9F, steep_cosine = 0.3F;

}  // namespace

PlaneMeter::PlaneMeter(const PointCloud& points, const DistanceField& field,
                       const std::optional<Plane>& table, const ObjectSymmetryBounds& bounds)
    : points_(points),
      field_(field),
      table_(table),
      bounds_(bounds),
      cells_(points.positions, cell_size),
      sample_(evenly_spread(points.size(), images_count)),
      thin_sample_(evenly_spread(points.size(), thin_images)),
      shell_(select(points, evenly_spread(points.size(), shell_points))),
      // The thinner the shell, the farther its points are apart.
      shell_gap_(0.008F *
                 std::sqrt(std::max(1.0F, static_cast<float>(points.size()) / shell_points))),
      centroid_(centroid(points.positions)),
      roundness_(distance_off_sphere(points.positions)) {
  const Eigen::Matrix3f axes = principal_axes(points.positions).cast<float>();
  const Points along = points.positions * axes;
  const Eigen::Vector3d extents =
      (along.colwise().maxCoeff() - along.colwise().minCoeff()).transpose().cast<double>();
  length_ = extents.maxCoeff();
  thickness_ = extents.minCoeff();
}

PlaneFeatures PlaneMeter::measure_images(const ReflectionPlane& plane) const {
  const PlaneReflector reflector(plane);
  const Eigen::Vector3f across = plane.normal.cast<float>();
  PlaneFeatures m;
  double count = 0.0, steep = 0.0;
  for (const Index i : sample_) {
    if (matches_itself(reflector, i)) continue;
    count += 1.0;
    const Eigen::Vector3f p = reflector.point(points_.position(i));
    const Eigen::Vector3f n = reflector.direction(points_.normal(i));
    const bool is_steep = std::abs(points_.normal(i).dot(across)) > steep_cosine;
    steep += is_steep ? 1.0 : 0.0;
    const Image image = meet(p, n);
    if (image.meeting == Meeting::agrees) {
      m.matched += 1.0;
      m.residual += double{image.offset};
      m.turn += double{safe_acos(image.cosine)};
      m.exact += image.offset < exact_offset && image.cosine > exact_cosine ? 1.0 : 0.0;
      m.steep_matched += is_steep ? 1.0 : 0.0;
    } else if (image.meeting == Meeting::disagrees) {
      m.off_surface += 1.0;
    } else if (field_.at(p) > empty_space) {
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

void PlaneMeter::measure_shape(const ReflectionPlane& plane, PlaneFeatures& m) const {
  const Eigen::Vector3f across = plane.normal.cast<float>();
  const Eigen::VectorXf facing = (points_.normals * across).cwiseAbs();
  const Eigen::VectorXf heights =
      points_.positions * across -
      Eigen::VectorXf::Constant(points_.positions.rows(),
                                static_cast<float>(plane.normal.dot(plane.point)));
  const auto count = static_cast<double>(points_.size());
  const auto near = static_cast<float>(bounds_.min_plane_distance);
  m.near = static_cast<double>((heights.array().abs() < near).count()) / count;
  const auto positive = static_cast<double>((heights.array() > 0.0F).count()) / count;
  m.balance = std::min(positive, 1.0 - positive);
  m.across = static_cast<double>((facing.array() < across_cosine).count()) / count;
  m.facing = static_cast<double>((facing.array() > facing_cosine).count()) / count;
  m.extent = static_cast<double>(heights.maxCoeff() - heights.minCoeff());
  const Eigen::Vector3d here = plane.project(centroid_);
  const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(plane.normal);
  const double tilt = std::tan(radians(12.0));
  for (const double sign : {-1.0, 1.0}) {
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector3d turned = (plane.normal + sign * tilt * basis.col(k)).normalized();
      m.tilted = std::max(m.tilted, share_matched({here, turned}));
    }
    const double shift = 0.08 * m.extent;
    m.shifted =
        std::max(m.shifted, share_matched({here + sign * shift * plane.normal, plane.normal}));
  }
  m.length = length_;
  m.thickness = thickness_;
  m.size = std::log(count);
  m.roundness = roundness_;
  m.upright = table_ ? std::abs(table_->normal.dot(plane.normal)) : -1.0;
}

bool PlaneMeter::matches_itself(const PlaneReflector& reflector, Index i) const {
  return std::abs(reflector.signed_distance(points_.position(i))) <
         static_cast<float>(bounds_.min_plane_distance);
}

PlaneMeter::Image PlaneMeter::meet(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const {
  const auto min_cosine = static_cast<float>(std::cos(bounds_.max_image_angle));
  const auto max_offset = static_cast<float>(bounds_.max_image_offset);
  Image best;
  best.offset = max_offset;
  cells_.for_each_within(p, agree, [&](Index j, float squared_distance) {
    const Eigen::Vector3f m = points_.normal(j);
    const float offset = std::abs(m.dot(p - points_.position(j)));
    if (m.dot(n) > min_cosine && offset < best.offset) {
      best = {Meeting::agrees, offset, m.dot(n)};
    } else if (best.meeting == Meeting::none && squared_distance < disagree * disagree) {
      best.meeting = Meeting::disagrees;
    }
  });
  return best;
}

/// Whether it lies behind a part of the surface that faces the same way.
bool PlaneMeter::is_buried(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const {
  constexpr float shallow = 0.004F, deep = 0.12F;  // [m]
  constexpr float same_way = 0.7F;                 // cosine
  for (Index k = 0; k < shell_.size(); ++k) {
    const Eigen::Vector3f to = shell_.position(k) - p;
    const float height = to.dot(n);
    if (height < shallow || height > deep || shell_.normal(k).dot(n) < same_way) continue;
    if (to.squaredNorm() - height * height < shell_gap_ * shell_gap_) return true;
  }
  return false;
}

double PlaneMeter::share_matched(const ReflectionPlane& plane) const {
  const PlaneReflector reflector(plane);
  double matched = 0.0, count = 0.0;
  for (const Index i : thin_sample_) {
    if (matches_itself(reflector, i)) continue;
    count += 1.0;
    const Image image =
        meet(reflector.point(points_.position(i)), reflector.direction(points_.normal(i)));
    matched += image.meeting == Meeting::agrees ? 1.0 : 0.0;
  }
  return count > 0.0 ? matched / count : 0.0;
}

}  // namespace symscene
