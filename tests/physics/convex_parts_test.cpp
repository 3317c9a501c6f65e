#include "symscene/physics/convex_parts.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "simulation/shapes.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// 16 cm wide, 6 cm high, walls of 8 mm.
TriangleMesh bowl() {
  const std::vector<ProfilePoint> profile = {{0, 0},        {0.045, 0},    {0.08, 0.06},
                                             {0.072, 0.06}, {0.04, 0.008}, {0, 0.008}};
  return make_revolution(profile, 24, 0.01);
}

TriangleMesh ball(double radius) {
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= 12; ++k) {
    const double angle = std::numbers::pi * k / 12.0;
    profile.push_back({k % 12 == 0 ? 0.0 : radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return make_revolution(profile, 24, 0.01);
}

TriangleMesh sheet() {
  TriangleMesh flat = make_box({0.1, 0.1, 0.05}, 0.02);
  flat.vertices.col(2).setZero();
  return flat;
}

TEST(ConvexParts, OfAConvexMeshAreOneAndOfABowlMany) {
  EXPECT_EQ(convex_parts(make_box({0.1, 0.05, 0.2}, 0.02)).size(), 1U);
  EXPECT_EQ(convex_parts(ball(0.05)).size(), 1U);
  const ConvexParts parts = convex_parts(bowl());
  EXPECT_GT(parts.size(), 4U);
  EXPECT_LE(parts.size(), static_cast<std::size_t>(ConvexPartsOptions{}.max_parts));
}

TEST(ConvexParts, AreNoMoreThanMaxParts) {
  ConvexPartsOptions options;
  options.max_parts = 3;
  options.concavity = 1e-4;
  EXPECT_LE(convex_parts(bowl(), options).size(), 3U);
}

TEST(ConvexParts, HoldEveryVertexOfTheMesh) {
  const TriangleMesh mesh = bowl();
  const ConvexParts parts = convex_parts(mesh);
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const bool is_held = std::any_of(parts.begin(), parts.end(), [&](const Points& part) {
      return (part.rowwise() - mesh.vertices.row(i)).rowwise().norm().minCoeff() == 0.0F;
    });
    ASSERT_TRUE(is_held) << i;
  }
}

TEST(ConvexParts, OfAFlatMeshAreRefused) {
  EXPECT_FALSE(is_solid(sheet()));
  EXPECT_THROW(convex_parts(sheet()), InputError);
}

TEST(ConvexPartsOptions, OutOfTheirRangeAreRefused) {
  ConvexPartsOptions options;
  options.max_parts = 0;
  EXPECT_THROW(options.validate(), InputError);
  EXPECT_THROW(convex_parts(ball(0.05), options), InputError);
}

}  // namespace
}  // namespace symscene
