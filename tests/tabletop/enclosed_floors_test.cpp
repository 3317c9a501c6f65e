#include "tabletop/enclosed_floors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/random.hpp"

namespace symscene {
namespace {

constexpr double clearance = 0.005;  // m
constexpr double cell = 0.01;        // m
constexpr double floor_radius = 0.06, wall_radius = 0.08;

/// Noisy samples 2 mm apart of a table with something on it, whose height depends on the place.
std::vector<PlaneSample> table_with(const std::function<double(const Eigen::Vector2d&)>& height,
                                    std::uint64_t seed) {
  Random random(seed);
  std::vector<PlaneSample> samples;
  for (double x = -0.2; x < 0.2; x += 0.002) {
    for (double y = -0.2; y < 0.2; y += 0.002) {
      const Eigen::Vector2d at(x, y);
      samples.push_back({at, height(at) + 0.0012 * random.normal()});
    }
  }
  return samples;
}

/// A plate or a ring: a wall around a floor of this height.
double vessel(const Eigen::Vector2d& at, double floor) {
  if (at.norm() < floor_radius) return floor;
  return at.norm() < wall_radius ? 0.03 : 0.0;
}

TEST(EnclosedFloors, FindsTheFloorOfAPlateAndNothingOfTheTable) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto samples = table_with([](const auto& at) { return vessel(at, 0.0035); }, seed);
    const auto floor = enclosed_floors(samples, clearance, cell);
    const auto inside = std::count_if(samples.begin(), samples.end(), [](const auto& sample) {
      return sample.within.norm() < floor_radius - cell && sample.height < clearance;
    });
    EXPECT_GT(static_cast<double>(floor.size()), 0.95 * static_cast<double>(inside));
    for (const std::size_t i : floor) EXPECT_LT(samples[i].within.norm(), wall_radius);
  }
}

TEST(EnclosedFloors, FindsAFloorBehindARimThatIsSmoothedAway) {
  const auto samples = table_with(
      [](const Eigen::Vector2d& at) {
        const bool is_near = at.y() < -0.055 && at.norm() < wall_radius;
        return is_near ? 0.0036 : vessel(at, 0.0035);
      },
      1);
  EXPECT_GT(enclosed_floors(samples, clearance, cell).size(), 1000U);
}

TEST(EnclosedFloors, LeavesTheTableInsideARing) {
  const auto samples = table_with([](const auto& at) { return vessel(at, 0.0); }, 1);
  EXPECT_TRUE(enclosed_floors(samples, clearance, cell).empty());
}

TEST(EnclosedFloors, MeasuresFloorsAgainstATableThatIsTooHigh) {
  const auto samples = table_with([](const auto& at) { return 0.002 + vessel(at, 0.0); }, 1);
  EXPECT_TRUE(enclosed_floors(samples, clearance, cell).empty());
}

TEST(EnclosedFloors, LeavesABumpOfTheTable) {
  const auto samples = table_with(
      [](const Eigen::Vector2d& at) { return at.norm() < floor_radius ? 0.0035 : 0.0; }, 1);
  EXPECT_TRUE(enclosed_floors(samples, clearance, cell).empty());
}

TEST(EnclosedFloors, OfNothingAreNone) {
  EXPECT_TRUE(enclosed_floors({}, clearance, cell).empty());
}

}  // namespace
}  // namespace symscene
