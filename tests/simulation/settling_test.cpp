#include "symscene/simulation/settling.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "simulation/household_object.hpp"
#include "simulation/shapes.hpp"
#include "simulation/true_surface.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/mesh.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

#define SKIP_WITHOUT_PHYSICS() \
  if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics"

ObjectModel revolved(const char* name, std::vector<ProfilePoint> profile) {
  return {name, make_revolution(profile, 24, 0.01), {}, {}, false};
}

/// 16 cm wide, 6 cm high, walls of 8 mm.
ObjectModel bowl() {
  return revolved("bowl",
                  {{0, 0}, {0.045, 0}, {0.08, 0.06}, {0.072, 0.06}, {0.04, 0.008}, {0, 0.008}});
}

ObjectModel ball(double radius) {
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= 12; ++k) {
    const double angle = std::numbers::pi * k / 12.0;
    profile.push_back({k % 12 == 0 ? 0.0 : radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return revolved("ball", profile);
}

ObjectModel box(const char* name, const Eigen::Vector3d& size) {
  return {name, make_box(size, 0.02), {}, {}, false};
}

std::vector<ObjectModel> household() {
  Random random(5);
  std::vector<ObjectModel> models;
  for (const ObjectKind kind :
       {ObjectKind::box, ObjectKind::can, ObjectKind::bowl, ObjectKind::bottle}) {
    models.push_back(make_household_object(kind, random, 0.8));
  }
  return models;
}

TabletopOptions objects_of(int count, std::uint64_t seed) {
  TabletopOptions options;
  options.objects = count;
  options.seed = seed;
  return options;
}

/// Coarser parts where sanitizers make them ten times slower to find.
DropOptions quick() {
  DropOptions options;
#ifdef SYMSCENE_SANITIZED
  options.parts.cell = 0.02;
  options.parts.max_cells = 10;
#endif
  return options;
}

std::vector<ObjectModel> models_of(const Tabletop& tabletop) {
  std::vector<ObjectModel> models;
  for (const PlacedObject& placed : tabletop.objects) models.push_back(placed.object);
  return models;
}

std::vector<Eigen::Isometry3d> poses_of(const Tabletop& tabletop) {
  std::vector<Eigen::Isometry3d> poses;
  for (const PlacedObject& placed : tabletop.objects) poses.push_back(placed.T_world_object);
  return poses;
}

/// The farthest that a vertex moves.
double largest_shift(const Tabletop& a, const Tabletop& b) {
  double shift = 0.0;
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    const Points moved = world_mesh(a.objects[i]).vertices - world_mesh(b.objects[i]).vertices;
    shift = std::max<double>(shift, moved.rowwise().norm().maxCoeff());
  }
  return shift;
}

void expect_above_table(const Tabletop& tabletop) {
  for (const PlacedObject& placed : tabletop.objects) {
    const double lowest = world_mesh(placed).vertices.col(2).minCoeff();
    EXPECT_GT(lowest, -0.002) << placed.object.name;
  }
}

void expect_at_rest(const Tabletop& tabletop) {
  DropOptions another_second = quick();
  another_second.settle_time = 1.0;
  const Tabletop later = settle(models_of(tabletop), poses_of(tabletop), another_second);
  EXPECT_LT(largest_shift(tabletop, later), 0.004);
}

TEST(Settling, ObjectsRestOnTheTableAndOnEachOther) {
  SKIP_WITHOUT_PHYSICS();
  const Tabletop tabletop = drop_tabletop(household(), objects_of(4, 1), quick());
  EXPECT_EQ(tabletop.objects.size(), 4U);
  expect_above_table(tabletop);
  expect_at_rest(tabletop);
}

TEST(Settling, ObjectsDoNotPenetrateEachOther) {
  SKIP_WITHOUT_PHYSICS();
  DropOptions crowded = quick();
  crowded.spread = 0.05;
  const Tabletop tabletop = drop_tabletop(household(), objects_of(4, 2), crowded);
  for (const PlacedObject& a : tabletop.objects) {
    for (const PlacedObject& b : tabletop.objects) {
      if (&a == &b) continue;
      const std::vector<TriangleMesh> other = {world_mesh(b)};
      const TrueSurface surface(other);
      const Points vertices = world_mesh(a).vertices;
      for (Eigen::Index i = 0; i < vertices.rows(); i += 29) {
        const Eigen::Vector3d p = vertices.row(i).transpose().cast<double>();
        if (surface.nearest(p, 0.005).mesh == 0 || !is_inside(other[0], p)) continue;
        ADD_FAILURE() << a.object.name << " is 5 mm in " << b.object.name;
        break;
      }
    }
  }
}

TEST(Settling, ASmallObjectDroppedIntoABowlStaysInside) {
  SKIP_WITHOUT_PHYSICS();
  const std::vector<ObjectModel> models = {bowl(), ball(0.02)};
  const std::vector<Eigen::Isometry3d> poses = {
      Eigen::Isometry3d::Identity(), Eigen::Isometry3d(Eigen::Translation3d(0.02, 0.01, 0.05))};
  const Tabletop tabletop = settle(models, poses);
  const Eigen::Vector3d center = tabletop.objects[1].T_world_object.translation();
  EXPECT_LT(center.head<2>().norm(), 0.045);
  EXPECT_NEAR(center.z(), 0.028, 0.006) << "on the bowl's floor, not on its rim";
}

TEST(Settling, AnObjectReleasedInTheAirFallsOntoTheTable) {
  SKIP_WITHOUT_PHYSICS();
  const std::vector<ObjectModel> models = {box("box", {0.06, 0.1, 0.15})};
  const std::vector<Eigen::Isometry3d> poses = {Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.1))};
  const Tabletop tabletop = settle(models, poses);
  EXPECT_NEAR(tabletop.objects[0].T_world_object.translation().z(), 0.0, 0.001);
}

TEST(Settling, TheSameSeedGivesTheSameBytesForAnyNumberOfThreads) {
  SKIP_WITHOUT_PHYSICS();
  const auto drop = [] { return poses_of(drop_tabletop(household(), objects_of(3, 4), quick())); };
  const auto one = testing::with_threads(1, drop);
  const auto two = testing::with_threads(2, drop);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].matrix(), two[i].matrix());
}

TEST(Settling, TheResultFollowsTheFrameOfTheTable) {
  SKIP_WITHOUT_PHYSICS();
  const std::vector<ObjectModel> models = {box("a", {0.1, 0.08, 0.06}), ball(0.04)};
  TabletopOptions options = objects_of(2, 3);
  const Tabletop upright = drop_tabletop(models, options, quick());
  options.random_frame = true;
  const Tabletop turned = drop_tabletop(models, options, quick());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE((turned.T_world_table.inverse() * turned.objects[i].T_world_object)
                    .isApprox(upright.objects[i].T_world_object, 1e-9));
  }
}

ObjectModel flat_model() {
  ObjectModel flat = box("sheet", {0.1, 0.1, 0.05});
  flat.mesh.vertices.col(2).setZero();
  return flat;
}

TEST(Settling, AFlatMeshIsNotUsedAndNamedInAWarning) {
  SKIP_WITHOUT_PHYSICS();
  const std::vector<ObjectModel> models = {flat_model(), box("box", {0.1, 0.1, 0.1})};
  const Tabletop tabletop = drop_tabletop(models, objects_of(1, 1), quick());
  ASSERT_EQ(tabletop.objects.size(), 1U);
  EXPECT_EQ(tabletop.objects[0].object.name, "box");
  ASSERT_EQ(tabletop.warnings.size(), 1U);
  EXPECT_EQ(tabletop.warnings[0], "sheet is not a solid and is not used");
}

TEST(Settling, RefusesModelsOfWhichNoneCanBeUsed) {
  const std::vector<ObjectModel> models = {flat_model(), box("crumb", {0.01, 0.01, 0.01})};
  EXPECT_THROW(drop_tabletop(models, objects_of(1, 1), quick()), InputError);
  EXPECT_THROW(drop_tabletop({}, objects_of(1, 1), quick()), InputError);
}

TEST(Settling, WithoutPhysicsDroppingIsRefused) {
  if (has_physics()) GTEST_SKIP() << "skipped: this build has physics";
  const std::vector<ObjectModel> models = {bowl()};
  EXPECT_THROW(drop_tabletop(models, objects_of(1, 1), quick()), InputError);
}

TEST(Settling, PhysicsThatFailsThrowsAndDoesNotEndTheProcess) {
  SKIP_WITHOUT_PHYSICS();
  const std::vector<ObjectModel> models = {ball(0.03)};
  Eigen::Isometry3d nowhere = Eigen::Isometry3d::Identity();
  nowhere.translation().setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(settle(models, std::vector<Eigen::Isometry3d>{nowhere}), std::runtime_error);
}

TEST(Settling, RefusesOptionsOutOfTheirRange) {
  DropOptions options;
  options.area = options.spread;
  EXPECT_THROW(options.validate(), InputError);
  options = {};
  options.parts.max_parts = 0;
  EXPECT_THROW(options.validate(), InputError);
}

TEST(Settling, ScannedMeshesRestOnTheTable) {
  SKIP_WITHOUT_PHYSICS();
  const char* variable = std::getenv("SYMSCENE_DATA");
  const std::filesystem::path data = variable != nullptr ? variable : "";
  if (!std::filesystem::exists(data / "ycb")) GTEST_SKIP() << "skipped: no $SYMSCENE_DATA/ycb";
  std::vector<ObjectModel> models;
  for (const char* name : {"024_bowl", "003_cracker_box", "056_tennis_ball", "011_banana"}) {
    models.push_back({name, read_mesh(data / "ycb" / (std::string(name) + ".ply")), {}, {}, false});
  }
  const Tabletop tabletop = drop_tabletop(models, objects_of(4, 1), quick());
  EXPECT_EQ(tabletop.objects.size(), 4U);
  expect_above_table(tabletop);
  expect_at_rest(tabletop);
}

}  // namespace
}  // namespace symscene
