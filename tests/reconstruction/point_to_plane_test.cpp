#include "reconstruction/point_to_plane.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "reconstruction/analytic_scenes.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

SurfaceImage surface_from(const Eigen::Isometry3d& pose) {
  return find_surface(render(tabletop(), small_camera(), pose).depth, small_camera(), {});
}

MatchOptions options() {
  return {.max_distance = 0.05,
          .max_angle = 0.5,
          .robust_sigmas = 2.0,
          .noise = {.floor = 5e-4F, .moved = 1.4e-3F, .fixed = 1.4e-3F}};
}

/// The definition, pixel by pixel in double precision.
NormalEquations by_definition(const SurfaceImage& moved, const SurfaceImage& fixed,
                              const Eigen::Isometry3d& T, const MatchOptions& o) {
  NormalEquations equations;
  const CameraIntrinsics& camera = fixed.camera;
  for (Index v = 0; v < moved.camera.height; ++v) {
    for (Index u = 0; u < moved.camera.width; ++u) {
      const SurfacePixel& pixel = moved.pixels[std::size_t{v} * moved.camera.width + u];
      if (!pixel.shows_surface()) continue;
      equations.fit.points += 1.0;
      const Eigen::Vector3d p = T * (double{pixel.depth} * moved.camera.ray(u, v));
      const Eigen::Vector2d at = camera.project(p).array().round();
      if (p.z() <= 0.05 || (at.array() < 0).any() || at.x() >= camera.width ||
          at.y() >= camera.height) {
        continue;
      }
      const SurfacePixel& other = fixed.pixels[static_cast<std::size_t>(at.y()) * camera.width +
                                               static_cast<std::size_t>(at.x())];
      if (!other.shows_surface()) continue;
      equations.fit.shown += 1.0;
      const Eigen::Vector3d gap = double{other.depth} * camera.ray(at.x(), at.y()) - p;
      const Eigen::Vector3d n = normal_of(other);
      const Eigen::Vector3d m = T.linear() * normal_of(pixel);
      if (gap.norm() > o.max_distance || m.dot(n) < std::cos(o.max_angle)) continue;
      const auto deviation = double{o.noise.deviation(pixel.depth, other.depth)};
      const double ratio = n.dot(gap) / (o.robust_sigmas * deviation);
      const double scale = double{o.noise.deviation(1.0F, 1.0F)} / deviation;
      const double weight = scale * scale / (1.0 + ratio * ratio);
      Vector6d J;
      J << p.cross(n), n;
      equations.H += weight * J * J.transpose();
      equations.b += weight * n.dot(gap) * J;
      equations.weight += weight;
      equations.fit.matches += 1.0;
      equations.fit.inliers += std::abs(n.dot(gap)) < 3.0 * deviation ? 1.0 : 0.0;
    }
  }
  return equations;
}

TEST(PointToPlane, EqualsTheSumOverAllPixels) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const SurfaceImage fixed = surface_from(around_table(0.0));
  const SurfaceImage moved = surface_from(around_table(0.1));
  for (int trial = 0; trial < 5; ++trial) {
    const Eigen::Vector3d turn(uniform(random), uniform(random), uniform(random));
    const Eigen::Vector3d shift(uniform(random), uniform(random), uniform(random));
    const Eigen::Isometry3d T =
        around_table(0.0).inverse() * around_table(0.1) * motion(0.005 * turn, 0.005 * shift);
    const NormalEquations found = PointToPlaneMatcher(moved, fixed, options()).match(T);
    const NormalEquations expected = by_definition(moved, fixed, T, options());
    ASSERT_GT(expected.fit.matches, 1000.0);
    EXPECT_EQ(found.fit.points, expected.fit.points);
    // Rounding may move a few pixels over a border.
    EXPECT_NEAR(found.fit.shown, expected.fit.shown, 10.0);
    EXPECT_NEAR(found.fit.matches, expected.fit.matches, 10.0);
    EXPECT_NEAR(found.fit.inliers, expected.fit.inliers, 10.0);
    EXPECT_NEAR(found.weight, expected.weight, 3e-3 * expected.weight);
    EXPECT_LT((found.H - expected.H).norm(), 3e-3 * expected.H.norm());
    EXPECT_LT((found.b - expected.b).norm(), 3e-3 * std::sqrt(expected.weight * expected.H.norm()));
  }
}

TEST(PointToPlane, IsSolvedByThePoseOfTheCamera) {
  const SurfaceImage fixed = surface_from(around_table(0.0));
  const SurfaceImage moved = surface_from(around_table(0.05));
  const Eigen::Isometry3d truth = around_table(0.0).inverse() * around_table(0.05);
  const PointToPlaneMatcher matcher(moved, fixed, options());
  Eigen::Isometry3d T = truth * motion({0.004, -0.003, 0.002}, {0.003, 0.002, -0.004});
  for (int k = 0; k < 10; ++k) {
    const NormalEquations equations = matcher.match(T);
    T = symscene::motion(equations.H.ldlt().solve(equations.b)) * T;
  }
  const Eigen::Isometry3d error = truth.inverse() * T;
  EXPECT_LT(error.translation().norm(), 1e-3);
  EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 1e-3);
}

TEST(DepthFit, CountsPointsInFreeSpaceAndNotOccludedOnes) {
  const SurfaceImage image = surface_from(around_table(0.0));
  const DepthNoise noise{.floor = 2e-3F, .moved = 0.0F, .fixed = 1.4e-3F};
  const auto fit_at = [&](double shift) {
    const Eigen::Isometry3d T(Eigen::Translation3d(0.0, 0.0, shift));
    return depth_fit(image, image, T, noise);
  };
  EXPECT_EQ(fit_at(0.0).overlap(), 1.0);
  EXPECT_EQ(fit_at(0.0).agreement(), 1.0);
  EXPECT_EQ(fit_at(0.0).residual(), 0.0);
  // In front of the surface that the same image shows.
  EXPECT_LT(fit_at(-0.05).agreement(), 0.2);
  EXPECT_GT(fit_at(-0.05).shown, 0.8 * fit_at(0.0).points);
  // Behind it.
  EXPECT_LT(fit_at(0.05).shown, 0.3 * fit_at(0.0).points);
}

}  // namespace
}  // namespace symscene
