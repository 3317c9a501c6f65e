#include <gtest/gtest.h>

#include <set>

#include "core/random_clouds.hpp"
#include "symmetry/curve_matching.hpp"
#include "symmetry/plane_mode.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// A straight curve of points 5 mm apart.
EdgeCurve straight(const Eigen::Vector3d& start, const Eigen::Vector3d& direction, int count) {
  EdgeCurve curve;
  for (int k = 0; k < count; ++k)
    curve.points.push_back({start + 0.005 * k * direction, direction, {}});
  return curve;
}

EdgeCurve transformed(EdgeCurve curve, const Eigen::Isometry3d& motion) {
  for (EdgeCurve::Point& point : curve.points) {
    point.position = motion * point.position;
    point.tangent = motion.linear() * point.tangent;
  }
  return curve;
}

EdgeCurve mirrored(EdgeCurve curve, const ReflectionPlane& plane) {
  for (EdgeCurve::Point& point : curve.points) {
    point.position = plane.reflect_point(point.position);
    point.tangent = plane.reflect_direction(point.tangent);
  }
  return curve;
}

/// A curve without symmetry of its own: a spiral that rises.
EdgeCurve spiral() {
  EdgeCurve curve;
  for (int k = 0; k < 40; ++k) {
    const double t = 0.1 * k, radius = 0.03 + 0.01 * t;
    const Eigen::Vector3d out(std::cos(t), std::sin(t), 0.0);
    const Eigen::Vector3d around(-std::sin(t), std::cos(t), 0.0);
    const Eigen::Vector3d tangent =
        (0.01 * out + radius * around + 0.02 * Eigen::Vector3d::UnitZ()).normalized();
    curve.points.push_back({radius * out + Eigen::Vector3d(0.15, 0.0, 0.02 * t), tangent, {}});
  }
  return curve;
}

TEST(MatchCurves, FindsThePlaneThatMirrorsACurveAndMovesWithIt) {
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const Eigen::Isometry3d motion = testing::random_motion(generator);
    const ReflectionPlane plane{motion.translation(), motion.linear() * Eigen::Vector3d::UnitX()};
    const EdgeCurve curve = transformed(spiral(), motion);
    const std::optional<CurveMatch> match = match_curves(curve, mirrored(curve, plane), {});
    ASSERT_TRUE(match) << "seed " << seed;
    const SymmetryDifference apart = difference(match->plane, plane, motion.translation());
    EXPECT_LT(apart.angle, radians(1.0));
    EXPECT_LT(apart.distance, 0.002);
    EXPECT_GT(match->inlier_ratio, 0.45);
  }
}

TEST(MatchCurves, MatchesPointsOneToOne) {
  const EdgeCurve a = spiral();
  const EdgeCurve b = mirrored(a, {});
  const std::optional<CurveMatch> match = match_curves(a, b, {});
  ASSERT_TRUE(match);
  std::set<Index> in_a, in_b;
  for (const CurveCorrespondence& pair : match->correspondences) {
    EXPECT_TRUE(in_a.insert(pair.a).second);
    EXPECT_TRUE(in_b.insert(pair.b).second);
    EXPECT_LE(pair.angle, CurveMatchingOptions{}.max_angle);
  }
  const EdgeCurve self = straight({0.0, 0.0, 0.0}, Eigen::Vector3d::UnitX(), 30);
  const std::optional<CurveMatch> own = match_curves(self, self, {});
  ASSERT_TRUE(own);
  std::set<Index> used;
  for (const CurveCorrespondence& pair : own->correspondences) {
    EXPECT_TRUE(used.insert(pair.a).second);
    EXPECT_TRUE(used.insert(pair.b).second);
  }
}

TEST(MatchCurves, MirrorsAStraightCurveOntoItselfAtItsMiddle) {
  const EdgeCurve curve = straight({0.1, 0.2, 0.3}, Eigen::Vector3d::UnitY(), 31);
  const std::optional<CurveMatch> match = match_curves(curve, curve, {});
  ASSERT_TRUE(match);
  EXPECT_LT(line_angle(match->plane.normal, Eigen::Vector3d::UnitY()), radians(0.5));
  EXPECT_NEAR(match->plane.signed_distance({0.1, 0.275, 0.3}), 0.0, 0.002);
  EXPECT_LE(match->inlier_ratio, 0.5);
}

TEST(MatchCurves, RefusesWhatReflectsNowhere) {
  const EdgeCurve along_x = straight({0.0, 0.0, 0.0}, Eigen::Vector3d::UnitX(), 20);
  // The same curve turned by a screw motion.
  const EdgeCurve skew = straight({0.0, 0.1, 0.0}, Eigen::Vector3d(1.0, 0.0, 1.0).normalized(), 20);
  EXPECT_FALSE(match_curves(along_x, skew, {}));
  // Farther apart than an object is large.
  const EdgeCurve far = straight({0.0, 1.0, 0.0}, Eigen::Vector3d::UnitX(), 20);
  EXPECT_FALSE(match_curves(along_x, far, {}));
}

TEST(MayMatch, NeverRefusesAPairThatMatches) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-0.15, 0.15);
  int matched = 0, refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto draw = [&] { return Eigen::Vector3d(uniform(generator), uniform(generator), 0.0); };
    const int count = 5 + static_cast<int>(generator() % 20);
    const EdgeCurve a = straight(draw(), draw().normalized(), count);
    const EdgeCurve b = trial % 3 == 0 ? mirrored(a, {draw(), draw().normalized()})
                                       : straight(draw(), draw().normalized(), count + trial % 9);
    const bool may = may_match(BoundedCurve(a), BoundedCurve(b), {});
    const bool does = match_curves(a, b, {}).has_value();
    EXPECT_TRUE(may || !does);
    matched += does ? 1 : 0;
    refused += may ? 0 : 1;
  }
  EXPECT_GT(matched, 100);
  EXPECT_GT(refused, 300);
}

TEST(DominantPlane, IsTheModeOfTheSamplesAndNotTheirMean) {
  std::mt19937 generator(2);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<MirrorSample> samples;
  for (int k = 0; k < 60; ++k) {
    const Eigen::Vector3d normal =
        Eigen::Vector3d(1.0, 0.02 * noise(generator), 0.02 * noise(generator)).normalized();
    // Either sign stands for the same plane.
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    samples.push_back({sign * normal, sign * (0.001 * noise(generator))});
  }
  for (int k = 0; k < 90; ++k) {
    const Eigen::Vector3d any(noise(generator), noise(generator), noise(generator));
    samples.push_back({any.normalized(), 0.1 * noise(generator)});
  }
  const std::optional<MirrorSample> mode = dominant_plane(samples, {radians(4.0), 0.006}, 400);
  ASSERT_TRUE(mode);
  EXPECT_LT(line_angle(mode->normal, Eigen::Vector3d::UnitX()), radians(1.0));
  EXPECT_NEAR(mode->offset, 0.0, 0.001);
}

TEST(DominantPlane, HasNoHoleAtTheReferencePoint) {
  // n / d is infinite for these planes and of opposite signs beside them.
  const PlaneKernel kernel{radians(4.0), 0.006};
  for (const double offset : {-0.001, 0.0, 0.001, 0.1}) {
    const std::vector<MirrorSample> samples{{Eigen::Vector3d::UnitZ(), offset + 0.0005},
                                            {-Eigen::Vector3d::UnitZ(), -offset + 0.0005}};
    const std::optional<MirrorSample> mode = dominant_plane(samples, kernel, 10);
    ASSERT_TRUE(mode);
    const double sign = mode->normal.z() > 0.0 ? 1.0 : -1.0;
    EXPECT_NEAR(sign * mode->offset, offset, 1e-9);
  }
}

TEST(DominantPlane, OfNothingIsNone) { EXPECT_FALSE(dominant_plane({}, {0.1, 0.1}, 10)); }

TEST(CurveDetectionOptions, RefuseEmptyRanges) {
  CurveDetectionOptions options;
  options.max_occlusion = options.min_occlusion;
  EXPECT_THROW(options.validate(), InputError);
  options = {};
  options.matching.max_distance = options.matching.min_distance;
  EXPECT_THROW(options.validate(), InputError);
}

}  // namespace
}  // namespace symscene
