#include "symscene/tabletop/cloud_scene.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/looking_at.hpp"
#include "core/random.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Points on a table at z = 0 and on a box of 10 cm on it, as a camera above sees them.
PointCloud table_with_box(bool with_table) {
  Random random(1);
  std::vector<Eigen::Vector3d> points;
  const auto add = [&](const Eigen::Vector3d& corner, const Eigen::Vector3d& along,
                       const Eigen::Vector3d& across, int count) {
    for (int i = 0; i < count; ++i)
      points.push_back(corner + random.uniform(0.0, 1.0) * along +
                       random.uniform(0.0, 1.0) * across);
  };
  if (with_table) add({-0.4, -0.3, 0}, {0.8, 0, 0}, {0, 0.6, 0}, 30000);
  add({0, 0, 0.1}, {0.1, 0, 0}, {0, 0.1, 0}, 1500);
  add({0, 0, 0}, {0.1, 0, 0}, {0, 0, 0.1}, 1500);
  add({0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}, 1500);
  PointCloud cloud;
  cloud.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    cloud.positions.row(static_cast<Eigen::Index>(i)) = points[i].cast<float>().transpose();
  return cloud;
}

const Eigen::Vector3d viewpoint(0.4, -0.8, 0.7);

TEST(CloudScene, ATableInTheCloudIsFoundAndCroppedWhereverItIs) {
  for (const double angle : {0.0, 1.0, 2.5}) {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.linear() =
        Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    motion.translation() << 3.0 * angle, -angle, 1.0;
    PointCloud cloud = table_with_box(true);
    const Eigen::Isometry3f moved = motion.cast<float>();
    cloud.positions = (cloud.positions * moved.linear().transpose()).eval();
    cloud.positions.rowwise() += moved.translation().transpose();
    const BuiltScene built = cloud_scene(cloud, motion * viewpoint);
    ASSERT_TRUE(built.scene.table) << angle;
    const Eigen::Vector3d up = motion.linear().col(2);
    EXPECT_LT(degrees(angle_between(built.scene.table->normal, up)), 1.0) << angle;
    EXPECT_GT(built.scene.cloud.size(), 600U);
    EXPECT_LT(built.scene.cloud.size(), 2500U);
    EXPECT_FALSE(built.scene.occupancy);
  }
}

/// The table with its box in the frame of a camera that looks along +z, rolled about that axis.
PointCloud seen_by_rolled_camera(double roll) {
  PointCloud cloud = table_with_box(true);
  const Eigen::Matrix3d R_world_camera = looking_along(viewpoint, -viewpoint.normalized()).linear();
  const Eigen::Matrix3d R = Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                            R_world_camera.transpose();
  cloud.positions.rowwise() -= viewpoint.cast<float>().transpose();
  cloud.positions = (cloud.positions * R.cast<float>().transpose()).eval();
  return cloud;
}

TEST(CloudScene, TheTableOfACameraThatLiesOnItsSideIsRatedAsThatOfAnUprightOne) {
  const auto built = [](const PointCloud& cloud, bool any_up) {
    return cloud_scene(cloud, Eigen::Vector3d::Zero(), {.any_up = any_up});
  };
  const auto score = [](const BuiltScene& scene) {
    return scene.table.planes.supports.empty() ? 0.0 : scene.table.planes.supports[0].score;
  };
  const BuiltScene upright = built(seen_by_rolled_camera(0.0), false);
  ASSERT_GT(score(upright), 0.0);
  EXPECT_FALSE(upright.table.is_against_up);
  const PointCloud on_its_side = seen_by_rolled_camera(radians(90.0));
  for (const bool any_up : {false, true}) {
    const BuiltScene turned = built(on_its_side, any_up);
    EXPECT_NEAR(score(turned), score(upright), 0.05 * score(upright));
    EXPECT_EQ(turned.table.is_against_up, !any_up);
  }
}

TEST(CloudScene, EstimatedNormalsPointToTheSensor) {
  const BuiltScene built = cloud_scene(table_with_box(true), viewpoint);
  for (Index i = 0; i < built.scene.cloud.size(); ++i) {
    const Eigen::Vector3d ray = viewpoint - built.scene.cloud.position(i).cast<double>();
    EXPECT_GT(built.scene.cloud.normal(i).cast<double>().dot(ray), -0.05);
  }
}

/// A sphere that stands at `middle`, seen from all sides.
PointCloud sphere_around(const Eigen::Vector3d& middle, double radius) {
  Random random(3);
  PointCloud cloud;
  cloud.positions.resize(8000, 3);
  for (Eigen::Index i = 0; i < cloud.positions.rows(); ++i) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    cloud.positions.row(i) = (middle + radius * direction).cast<float>().transpose();
  }
  return cloud;
}

TEST(CloudScene, EstimatedNormalsOfAFusedCloudPointOutwardsOnTheFarSideToo) {
  const Eigen::Vector3d middle(0.1, 0.2, 0.9);
  const PointCloud sphere = sphere_around(middle, 0.08);
  for (const Eigen::Vector3d& eye : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.3, -0.5, 1.2)}) {
    const BuiltScene built = cloud_scene(sphere, eye);
    ASSERT_GT(built.scene.cloud.size(), 1000U);
    Index inwards = 0;
    for (Index i = 0; i < built.scene.cloud.size(); ++i) {
      const Eigen::Vector3d radial = built.scene.cloud.position(i).cast<double>() - middle;
      inwards += built.scene.cloud.normal(i).cast<double>().dot(radial) < 0.0 ? 1 : 0;
    }
    // The far side may be seen through a gap between the random points.
    EXPECT_LT(100 * inwards, built.scene.cloud.size());
    EXPECT_NE(built.scene.warnings.back().find("no usable normals"), std::string::npos);
  }
}

TEST(CloudScene, TheOriginAmidAFusedCloudIsNoViewpoint) {
  const Eigen::Vector3d middle(-0.1, 0.0, 0.08);
  const PointCloud sphere = sphere_around(middle, 0.08), table = table_with_box(true);
  PointCloud cloud;
  cloud.positions.resize(sphere.positions.rows() + table.positions.rows(), 3);
  cloud.positions << sphere.positions, table.positions;
  const BuiltScene built = cloud_scene(cloud, middle);
  ASSERT_TRUE(built.scene.table);
  EXPECT_GT(built.scene.table->normal.z(), 0.99);
  EXPECT_GT(built.scene.cloud.size(), 2500U) << "the sphere and the box";
}

TEST(CloudScene, AnOriginBesideTheCloudAtTheHeightOfItsTableIsNoViewpoint) {
  PointCloud cloud = table_with_box(true);
  for (const float height : {0.0F, 0.004F}) {
    const BuiltScene built = cloud_scene(cloud, {-0.6, 0.1, double{height}});
    ASSERT_TRUE(built.scene.table) << height;
    EXPECT_GT(built.scene.table->normal.z(), 0.99) << height;
    EXPECT_GT(built.scene.cloud.size(), 600U) << height;
    Index top = 0, upwards = 0;
    for (Index i = 0; i < built.scene.cloud.size(); ++i) {
      if (std::abs(built.scene.cloud.normal(i).z()) < 0.9F) continue;
      ++top;
      upwards += built.scene.cloud.normal(i).z() > 0.0F ? 1 : 0;
    }
    EXPECT_GT(upwards, 0.98 * top) << height;
    EXPECT_NE(built.scene.warnings.back().find("as seen from"), std::string::npos);
  }
}

TEST(CloudScene, TheWarningOfEstimatedNormalsSaysWhereTheSensorWas) {
  const BuiltScene built = cloud_scene(table_with_box(true), viewpoint);
  EXPECT_NE(built.scene.warnings.back().find("the sensor at (0.40, -0.80, 0.70)"),
            std::string::npos);
}

TEST(CloudScene, WithoutItsTableAllPointsAreKept) {
  const BuiltScene built = cloud_scene(table_with_box(false), viewpoint);
  EXPECT_FALSE(built.scene.table);
  EXPECT_GT(built.scene.cloud.size(), 800U);
  const BuiltScene asked = cloud_scene(table_with_box(true), viewpoint, {.absent = true});
  EXPECT_FALSE(asked.scene.table);
  EXPECT_GT(asked.scene.cloud.size(), 10000U);
}

TEST(CloudScene, RefusesACloudWithoutSurface) {
  EXPECT_THROW(cloud_scene({}, viewpoint), InputError);
  PointCloud nowhere;
  nowhere.positions = Points::Constant(10, 3, std::numeric_limits<float>::quiet_NaN());
  EXPECT_THROW(cloud_scene(nowhere, viewpoint), InputError);
}

}  // namespace
}  // namespace symscene
