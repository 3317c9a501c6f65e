#include "symscene/simulation/scanned_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulation/shapes.hpp"

namespace symscene {
namespace {

/// A body of revolution that is lower than wide by a factor.
TriangleMesh ellipsoid(double flattening) {
  constexpr double radius = 0.05;
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= 24; ++k) {
    const double angle = k * std::numbers::pi / 24;
    profile.push_back(
        {k % 24 == 0 ? 0.0 : radius * std::sin(angle), -radius * flattening * std::cos(angle)});
  }
  return make_revolution(profile, 48, 0.01);
}

TEST(ScannedModels, ABallIsKnownByItsSurface) {
  EXPECT_TRUE(is_ball(ellipsoid(1.0)));
  EXPECT_TRUE(is_ball(ellipsoid(0.97)));
  EXPECT_FALSE(is_ball(ellipsoid(0.85)));
  EXPECT_FALSE(is_ball(make_box({0.1, 0.1, 0.1}, 0.02)));
}

}  // namespace
}  // namespace symscene
