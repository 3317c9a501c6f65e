#include "initial_surfaces.hpp"

#include <algorithm>
#include <array>
#include <complex>

#include <Eigen/Dense>

#include "core/median.hpp"
#include "symmetry_frame.hpp"

namespace symscene {
namespace {

constexpr std::array<int, 3> prism_sides = {3, 5, 6};
constexpr std::size_t tried_normals = 60;
constexpr std::size_t tried_axes = 2;
constexpr double parallel_cosine = 0.97;  // of normals that are one direction
constexpr double across_cosine = 0.25;    // of normals at right angles to a direction
constexpr double same_axis_cosine = 0.99;

/// The direction that most normals are parallel or opposite to, of those at right angles to
/// `across` if that is given; none without such normals.
std::optional<Eigen::Vector3d> commonest_direction(const FitSamples& samples,
                                                   const Eigen::Vector3d* across,
                                                   double min_share) {
  const std::size_t step = std::max<std::size_t>(1, samples.size() / tried_normals);
  std::size_t best_count = 0;
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < samples.size(); k += step) {
    const Eigen::Vector3d& tried = samples.normals[k];
    if (across != nullptr && std::abs(tried.dot(*across)) > across_cosine) continue;
    std::size_t count = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& normal : samples.normals) {
      const double cosine = normal.dot(tried);
      if (std::abs(cosine) < parallel_cosine) continue;
      ++count;
      sum += cosine > 0.0 ? normal : Eigen::Vector3d(-normal);
    }
    if (count <= best_count) continue;
    best_count = count;
    best = sum;
  }
  if (static_cast<double>(best_count) < min_share * static_cast<double>(samples.size()) ||
      best.norm() == 0.0)
    return std::nullopt;
  return best.normalized();
}

void add_box(const FitSamples& samples, const Eigen::Vector3d& first, const FitBounds& bounds,
             std::vector<SurfaceModel>& surfaces) {
  const auto second = commonest_direction(samples, &first, bounds.min_face_share);
  if (!second) return;
  SurfaceModel box;
  box.origin = samples.center;
  box.axes.col(0) = first;
  box.axes.col(1) = (*second - first.dot(*second) * first).normalized();
  box.axes.col(2) = box.axes.col(0).cross(box.axes.col(1));
  place_planar_faces(box, samples, bounds);
  surfaces.push_back(box);
}

/// Directions of an axis: normals are along it or across it.
std::vector<Eigen::Vector3d> likely_axes(const FitSamples& samples,
                                         const std::vector<Eigen::Vector3d>& directions) {
  std::vector<std::pair<double, Eigen::Vector3d>> rated;
  for (const Eigen::Vector3d& direction : directions) {
    double fitting = 0.0;
    for (const Eigen::Vector3d& normal : samples.normals) {
      const double cosine = std::abs(normal.dot(direction));
      fitting += cosine < 0.5 * across_cosine || cosine > parallel_cosine ? 1.0 : 0.0;
    }
    rated.push_back({fitting, direction});
  }
  std::stable_sort(rated.begin(), rated.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Eigen::Vector3d> likely;
  for (const auto& [fitting, direction] : rated) {
    const Eigen::Vector3d& tried = direction;
    const bool is_new = std::none_of(likely.begin(), likely.end(), [&](const auto& other) {
      return std::abs(other.dot(tried)) > same_axis_cosine;
    });
    if (is_new && likely.size() < tried_axes) likely.push_back(direction);
  }
  return likely;
}

/// The direction to which the normals are most nearly at right angles.
Eigen::Vector3d least_normal_direction(const FitSamples& samples) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& normal : samples.normals) sum += normal * normal.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(0);
}

/// Samples whose normals are across an axis, in its frame about the samples' centre.
struct SideSamples {
  std::vector<Eigen::Vector2d> positions, normals;
};

SideSamples side_samples(const FitSamples& samples, const Eigen::Matrix3d& frame) {
  SideSamples sides;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d normal = frame.transpose() * samples.normals[i];
    if (std::abs(normal.z()) > across_cosine) continue;
    const Eigen::Vector3d local = frame.transpose() * (samples.positions[i] - samples.center);
    sides.positions.push_back(local.head<2>());
    sides.normals.push_back(normal.head<2>().normalized());
  }
  return sides;
}

/// Where the lines of the normals meet, and the median distance of the points from there along
/// them: Σ (I − n nᵀ)(p − c) = 0.
void place_cylinder(const SideSamples& sides, SurfaceModel& cylinder) {
  Eigen::Matrix2d sum = 1e-9 * Eigen::Matrix2d::Identity();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < sides.positions.size(); ++i) {
    const Eigen::Matrix2d across =
        Eigen::Matrix2d::Identity() - sides.normals[i] * sides.normals[i].transpose();
    sum += across;
    right += across * sides.positions[i];
  }
  const Eigen::Vector2d center = sum.ldlt().solve(right);
  std::vector<double> radii;
  for (std::size_t i = 0; i < sides.positions.size(); ++i)
    radii.push_back(sides.normals[i].dot(sides.positions[i] - center));
  cylinder.size = median(std::move(radii)).value_or(0.0);
  cylinder.origin += cylinder.axes.leftCols<2>() * center;
}

/// Turns a regular prism about its axis so that its faces have the normals of the points, and
/// places it: m · (c + a m) = m · p for the normals m of its faces.
bool place_prism(const SideSamples& sides, double min_share, SurfaceModel& prism) {
  std::complex<double> phase = 0.0;
  for (const Eigen::Vector2d& n : sides.normals)
    phase += std::polar(1.0, prism.sides * std::atan2(n.y(), n.x()));
  const double turn = std::arg(phase) / prism.sides;
  const Eigen::Matrix3d about_axis =
      Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  std::vector<std::size_t> counts(static_cast<std::size_t>(prism.sides), 0);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < sides.positions.size(); ++i) {
    for (int f = 0; f < prism.sides; ++f) {
      const Eigen::Vector2d face =
          (about_axis * prism.normal(SurfaceModel::planar_faces + f, Eigen::Vector3d::Zero()))
              .head<2>();
      if (face.dot(sides.normals[i]) < parallel_cosine) continue;
      const Eigen::Vector3d row(face.x(), face.y(), 1.0);
      sum += row * row.transpose();
      right += face.dot(sides.positions[i]) * row;
      ++counts[static_cast<std::size_t>(f)];
    }
  }
  const auto seen = std::count_if(counts.begin(), counts.end(), [&](std::size_t count) {
    return static_cast<double>(count) > min_share * static_cast<double>(sides.positions.size());
  });
  if (seen < 3) return false;
  const Eigen::Vector3d solved = sum.ldlt().solve(right);
  prism.size = solved.z();
  prism.origin += prism.axes.leftCols<2>() * solved.head<2>();
  prism.axes = prism.axes * about_axis;
  return prism.size > 0.0;
}

void add_about_axis(const FitSamples& samples, const Eigen::Vector3d& axis, const FitBounds& bounds,
                    std::vector<SurfaceModel>& surfaces) {
  SurfaceModel model;
  model.axes = frame_about(axis);
  model.origin = samples.center;
  const SideSamples sides = side_samples(samples, model.axes);
  if (sides.positions.size() < 8) return;
  SurfaceModel cylinder = model;
  cylinder.kind = SurfaceModel::Kind::cylinder;
  place_cylinder(sides, cylinder);
  if (cylinder.size > 0.0 && cylinder.size < samples.diagonal) {
    place_planar_faces(cylinder, samples, bounds);
    surfaces.push_back(cylinder);
  }
  for (const int count : prism_sides) {
    SurfaceModel prism = model;
    prism.kind = SurfaceModel::Kind::prism;
    prism.sides = count;
    if (!place_prism(sides, bounds.min_face_share, prism) || prism.size > samples.diagonal)
      continue;
    place_planar_faces(prism, samples, bounds);
    surfaces.push_back(prism);
  }
}

/// Where the lines of the normals meet.
void add_sphere(const FitSamples& samples, std::vector<SurfaceModel>& surfaces) {
  Eigen::Matrix3d sum = 1e-9 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - samples.normals[i] * samples.normals[i].transpose();
    sum += across;
    right += across * (samples.positions[i] - samples.center);
  }
  SurfaceModel sphere;
  sphere.kind = SurfaceModel::Kind::sphere;
  sphere.origin = samples.center + sum.ldlt().solve(right);
  std::vector<double> radii;
  for (std::size_t i = 0; i < samples.size(); ++i)
    radii.push_back(samples.normals[i].dot(samples.positions[i] - sphere.origin));
  sphere.size = median(std::move(radii)).value_or(0.0);
  if (sphere.size > 0.0 && sphere.size < samples.diagonal) surfaces.push_back(sphere);
}

}  // namespace

std::vector<SurfaceModel> initial_surfaces(const FitSamples& samples,
                                           const std::vector<Eigen::Vector3d>& directions,
                                           const FitBounds& bounds) {
  std::vector<SurfaceModel> surfaces;
  add_sphere(samples, surfaces);
  std::vector<Eigen::Vector3d> tried = directions;
  tried.push_back(least_normal_direction(samples));
  const auto commonest = commonest_direction(samples, nullptr, bounds.min_face_share);
  if (commonest) {
    tried.push_back(*commonest);
    add_box(samples, *commonest, bounds, surfaces);
  }
  for (const Eigen::Vector3d& axis : likely_axes(samples, tried))
    add_about_axis(samples, axis, bounds, surfaces);
  return surfaces;
}

}  // namespace symscene
