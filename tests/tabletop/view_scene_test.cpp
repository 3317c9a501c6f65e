#include "symscene/tabletop/view_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

#include "core/looking_at.hpp"
#include "core/random.hpp"
#include "symscene/core/error.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"
#include "tabletop/support_plane.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

/// An analytic world of rectangles, seen by a pinhole camera.
struct Rectangle {
  Eigen::Vector3d corner, along, across;  ///< the sides are perpendicular [m]
  int label = 0;                          ///< 0 is the table, -1 what is behind it
};

struct World {
  std::vector<Rectangle> rectangles;

  void add(const Eigen::Vector3d& corner, const Eigen::Vector3d& along,
           const Eigen::Vector3d& across, int label) {
    rectangles.push_back({corner, along, across, label});
  }
  /// The faces of a box that stands at z, but for its bottom.
  void add_box(const Eigen::Vector3d& low, const Eigen::Vector3d& size, int label) {
    const Eigen::Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    add(low + z, x, y, label);
    for (const Eigen::Vector3d& shift : {Eigen::Vector3d(0, 0, 0), y})
      add(low + shift, x, z, label);
    for (const Eigen::Vector3d& shift : {Eigen::Vector3d(0, 0, 0), x})
      add(low + shift, y, z, label);
  }

  /// The distance along a ray to the nearest rectangle, and its label.
  std::pair<double, int> hit(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) const {
    std::pair<double, int> nearest{0.0, -2};
    for (const Rectangle& r : rectangles) {
      const Eigen::Vector3d normal = r.along.cross(r.across);
      const double t = normal.dot(r.corner - eye) / normal.dot(ray);
      const Eigen::Vector3d at = eye + t * ray - r.corner;
      const double a = at.dot(r.along) / r.along.squaredNorm();
      const double b = at.dot(r.across) / r.across.squaredNorm();
      if (!(t > 0.0) || a < 0.0 || a > 1.0 || b < 0.0 || b > 1.0) continue;
      if (nearest.second == -2 || t < nearest.first) nearest = {t, r.label};
    }
    return nearest;
  }
};

struct Image {
  CameraIntrinsics camera{160, 120, 135.0, 135.0, 79.5, 59.5};
  DepthFrame frame;
  std::vector<int> labels;
};

Image render(const World& world, const Eigen::Isometry3d& pose, double noise = 0.0,
             std::uint64_t seed = 1) {
  Image image;
  Random random(seed);
  for (Index v = 0; v < image.camera.height; ++v) {
    for (Index u = 0; u < image.camera.width; ++u) {
      const auto [depth, label] =
          world.hit(pose.translation(), pose.linear() * image.camera.ray(u, v));
      const double error = noise * depth * depth * random.normal();
      image.frame.depth.push_back(static_cast<float>(depth > 0.0 ? depth + error : 0.0));
      image.labels.push_back(label);
    }
  }
  return image;
}

/// A table at z = 0.75 with three boxes, and the floor around it.
World table_on_floor() {
  World world;
  world.add({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}, -1);
  world.add({-0.5, -0.35, 0.75}, {1.0, 0, 0}, {0, 0.7, 0}, 0);
  world.add_box({-0.25, -0.1, 0.75}, {0.1, 0.1, 0.12}, 1);
  world.add_box({0.0, 0.0, 0.75}, {0.08, 0.15, 0.2}, 2);
  world.add_box({0.2, -0.15, 0.75}, {0.12, 0.08, 0.06}, 3);
  return world;
}

/// How many points of a scene belong to each label.
std::map<int, int> labels_of(const Scene& scene, const Image& image,
                             const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity()) {
  std::map<int, int> counts;
  for (Index i = 0; i < scene.cloud.size(); ++i) {
    const Eigen::Vector3d point = pose.inverse() * scene.cloud.position(i).cast<double>();
    const Eigen::Vector2d pixel = image.camera.project(point);
    const auto u = static_cast<std::size_t>(std::lround(pixel.x()));
    const auto v = static_cast<std::size_t>(std::lround(pixel.y()));
    ++counts[image.labels[v * image.camera.width + u]];
  }
  return counts;
}

void expect_table(const ViewScene& view, const Eigen::Isometry3d& pose, double height) {
  ASSERT_TRUE(view.built.scene.table);
  const Eigen::Vector3d up = pose.linear().transpose() * Eigen::Vector3d::UnitZ();
  EXPECT_LT(degrees(angle_between(view.built.scene.table->normal, up)), 0.5);
  const Eigen::Vector3d on_table = pose.inverse() * Eigen::Vector3d(0, 0, height);
  EXPECT_NEAR(view.built.scene.table->signed_distance(on_table), 0.0, 0.003);
}

const std::array<double, 3> distances = {0.6, 1.2, 2.0};
constexpr double noise = 1.425e-3;

TEST(ViewPoints, HaveTheNormalsOfTheirPlaneAtEveryDistance) {
  for (const double distance : distances) {
    World world;
    world.add({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, 0);
    const Eigen::Isometry3d pose = looking_at({0, -0.8 * distance, 0.6 * distance}, {0, 0, 0});
    const Image image = render(world, pose, noise);
    const ViewPoints points = unproject(image.frame, image.camera);
    ASSERT_GT(points.cloud.size(), 0.95 * static_cast<double>(image.camera.pixels()));
    const Eigen::Vector3f up = (pose.linear().transpose() * Eigen::Vector3d::UnitZ()).cast<float>();
    double squares = 0.0;
    for (Index i = 0; i < points.cloud.size(); ++i)
      squares += std::pow(std::acos(std::min(points.cloud.normal(i).dot(up), 1.0F)), 2);
    const double deviation = std::sqrt(squares / points.cloud.size());
    EXPECT_LT(deviation, 5.0 * ViewPointOptions().normal_noise) << distance;
  }
}

TEST(ViewPoints, AreInTheirPixels) {
  const Eigen::Isometry3d pose = looking_at({0, -1, 1.6}, {0, 0, 0.8});
  const Image image = render(table_on_floor(), pose);
  const ViewPoints points = unproject(image.frame, image.camera);
  ASSERT_EQ(points.pixels.size(), points.cloud.size());
  std::set<Index> distinct(points.pixels.begin(), points.pixels.end());
  EXPECT_EQ(distinct.size(), points.pixels.size());
  for (Index i = 0; i < points.cloud.size(); ++i) {
    const Eigen::Vector2d pixel = image.camera.project(points.cloud.position(i).cast<double>());
    ASSERT_NEAR(pixel.x(), points.pixels[i] % image.camera.width, 0.01);
    ASSERT_NEAR(pixel.y(), points.pixels[i] / image.camera.width, 0.01);
    EXPECT_LT(points.cloud.normal(i).dot(points.cloud.position(i)), 0.0F);
  }
}

TEST(ViewPoints, OfAnImageWithAHoleAtEveryThirdPixelAreOnTheSameSurface) {
  const Eigen::Isometry3d pose = looking_at({0, -1, 1.6}, {0, 0, 0.8});
  Image image = render(table_on_floor(), pose, noise);
  const Index whole = unproject(image.frame, image.camera).cloud.size();
  Index holes = 0;
  for (Index v = 0; v < image.camera.height; ++v) {
    for (Index u = 0; u < image.camera.width; ++u) {
      if (u % 3 != 1 && v % 3 != 1) continue;
      image.frame.depth[v * image.camera.width + u] = 0.0F;
      ++holes;
    }
  }
  const double share =
      1.0 - static_cast<double>(holes) / static_cast<double>(image.camera.pixels());
  EXPECT_GT(unproject(image.frame, image.camera).cloud.size(), 0.9 * share * whole);
}

TEST(ViewPoints, ThinThingsKeepTheirPointsAndFlyingPixelsDoNot) {
  World world;
  world.add({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, 0);
  world.add({-0.2, -0.01, 0.3}, {0.4, 0, 0}, {0, 0.02, 0}, 1);  // a strip 3 pixels wide
  const Eigen::Isometry3d pose = looking_at({0, 0, 1.2}, {0, 0, 0}, Eigen::Vector3d::UnitY());
  Image image = render(world, pose, 0.5 * noise);
  std::vector<bool> flying(image.camera.pixels(), false);
  for (Index v = 10; v < 20; ++v) {
    const std::size_t i = std::size_t{v} * image.camera.width + 80;
    image.frame.depth[i] = 0.5F + 0.05F * static_cast<float>(v - 10);
    flying[i] = true;
  }
  const ViewPoints points = unproject(image.frame, image.camera);
  std::size_t strip = 0, all = 0, flown = 0;
  for (const int label : image.labels) all += label == 1 ? 1 : 0;
  for (const Index pixel : points.pixels) {
    strip += image.labels[pixel] == 1 ? 1 : 0;
    flown += flying[pixel] ? 1 : 0;
  }
  ASSERT_GT(all, 100U);
  EXPECT_GT(strip, 0.9 * static_cast<double>(all));
  EXPECT_EQ(flown, 0U);
}

TEST(ViewPoints, TheMeshDoesNotSpanDepthEdges) {
  const Eigen::Isometry3d pose = looking_at({0, -1, 1.6}, {0, 0, 0.8});
  const Image image = render(table_on_floor(), pose);
  const TriangleMesh mesh = view_mesh(unproject(image.frame, image.camera));
  ASSERT_GT(mesh.triangles.rows(), 10000);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    std::array<float, 3> z{};
    for (int k = 0; k < 3; ++k)
      z[static_cast<std::size_t>(k)] = mesh.vertices(mesh.triangles(t, k), 2);
    EXPECT_LT(*std::max_element(z.begin(), z.end()) - *std::min_element(z.begin(), z.end()), 0.15F);
  }
}

TEST(ViewScene, TheTableIsFoundBeforeALargerFloorAtEveryDistance) {
  for (const double distance : distances) {
    const Eigen::Vector3d middle(0, 0, 0.78);
    const Eigen::Isometry3d pose =
        looking_at(middle + distance * Eigen::Vector3d(0.1, -0.75, 0.65), middle);
    const Image image = render(table_on_floor(), pose, noise);
    const ViewScene view = view_scene({image.frame, image.camera});
    expect_table(view, pose, 0.75);
    const std::map<int, int> counts = labels_of(view.built.scene, image);
    for (const int object : {1, 2, 3}) EXPECT_GT(counts.at(object), 50) << object;
    EXPECT_EQ(counts.count(-1), 0U);
  }
}

TEST(ViewScene, ACameraThatLooksStraightDownFindsItsTable) {
  for (const double turn : {0.0, 1.0, 2.0, 4.0}) {
    const Eigen::Vector3d side(std::cos(turn), std::sin(turn), 0.0);
    const Eigen::Isometry3d pose = looking_at({0, 0, 1.65}, {0, 0, 0}, side);
    const Image image = render(table_on_floor(), pose, noise);
    const ViewScene view = view_scene({image.frame, image.camera});
    expect_table(view, pose, 0.75);
    const std::map<int, int> counts = labels_of(view.built.scene, image);
    for (const int object : {1, 2, 3}) EXPECT_GT(counts.at(object), 50) << object;
  }
}

TEST(ViewScene, ACameraOnItsSideOrUpsideDownFindsItsTableAndWarns) {
  const auto warns = [](const ViewScene& view) {
    const std::vector<std::string>& warnings = view.built.scene.warnings;
    return std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
      return warning.find("held upright") != std::string::npos;
    });
  };
  using Eigen::Vector3d;
  for (const Vector3d& up : {Vector3d(0, 0, -1), Vector3d(1, 0, 0), Vector3d(-1, 0, 0)}) {
    const Eigen::Isometry3d pose = looking_at({0.05, -1.1, 1.25}, {0, 0, 0.8}, up);
    const Image image = render(table_on_floor(), pose, noise);
    const ViewScene view = view_scene({image.frame, image.camera});
    expect_table(view, pose, 0.75);
    const std::map<int, int> counts = labels_of(view.built.scene, image);
    for (const int object : {1, 2, 3}) EXPECT_GT(counts.at(object), 50) << object;
    EXPECT_TRUE(warns(view)) << up.transpose();
  }
  const Image upright = render(table_on_floor(), looking_at({0, -1.1, 1.25}, {0, 0, 0.8}), noise);
  EXPECT_FALSE(warns(view_scene({upright.frame, upright.camera})));
}

TEST(ViewScene, AFaceOfAnObjectWithSomethingOnItIsNoTableOfACameraOnItsSide) {
  World world = table_on_floor();
  world.rectangles.erase(world.rectangles.begin());  // the floor
  // A box whose side faces the upward direction of the turned camera, with a knob on that side.
  world.add_box({-0.45, 0.05, 0.75}, {0.1, 0.25, 0.25}, 4);
  world.add_box({-0.35, 0.12, 0.82}, {0.06, 0.08, 0.08}, 5);
  const Eigen::Isometry3d pose = looking_at({0.5, -0.9, 1.35}, {0, 0, 0.8}, {1, 0, 0});
  const Image image = render(world, pose, noise);
  const ViewScene view = view_scene({image.frame, image.camera});
  expect_table(view, pose, 0.75);
  EXPECT_TRUE(view.built.table.is_against_up);
}

TEST(ViewScene, AnEmptyTableIsNotReplacedByASmallerWallWithThingsOnIt) {
  World world;
  world.add({-0.5, -0.35, 0.75}, {1.0, 0, 0}, {0, 0.7, 0}, 0);
  world.add({-0.3, 0.36, 0.75}, {0.6, 0, 0}, {0, 0, 0.5}, -1);
  world.add_box({-0.1, 0.26, 0.95}, {0.2, 0.1, 0.1}, 1);
  const Eigen::Isometry3d pose = looking_at({0, -0.9, 1.3}, {0, 0, 0.85});
  const Image image = render(world, pose, noise);
  const ViewScene view = view_scene({image.frame, image.camera});
  expect_table(view, pose, 0.75);
}

TEST(ViewScene, WhatStandsBehindAShadowThatSplitsTheTableIsKept) {
  World world = table_on_floor();
  world.add_box({-0.5, -0.3, 0.75}, {1.0, 0.05, 0.15}, 4);  // from border to border
  const Eigen::Isometry3d pose = looking_at({0, -1.0, 1.5}, {0, 0, 0.8});
  const Image image = render(world, pose, noise);
  const ViewScene view = view_scene({image.frame, image.camera});
  expect_table(view, pose, 0.75);
  const std::map<int, int> counts = labels_of(view.built.scene, image);
  for (const int object : {1, 2, 3, 4}) EXPECT_GT(counts.at(object), 30) << object;
}

TEST(ViewScene, MovesWithTheCamera) {
  const Eigen::Isometry3d pose = looking_at({0, -1, 1.6}, {0, 0, 0.8});
  const Image image = render(table_on_floor(), pose, noise);
  const ViewScene in_camera = view_scene({image.frame, image.camera});
  const ViewScene in_world = view_scene({image.frame, image.camera, pose});
  ASSERT_TRUE(in_camera.built.scene.table && in_world.built.scene.table);
  const Eigen::Vector3d turned = pose.linear() * in_camera.built.scene.table->normal;
  EXPECT_LT(degrees(angle_between(turned, in_world.built.scene.table->normal)), 0.3);
  const double points = in_camera.built.scene.cloud.size();
  EXPECT_NEAR(in_world.built.scene.cloud.size(), points, 0.1 * points);
}

TEST(ViewScene, SpaceIsFreeBeforeTheSurfaceAndUnknownBehindItAndInHoles) {
  const Eigen::Isometry3d pose = looking_at({0, -1, 1.6}, {0, 0, 0.8});
  Image image = render(table_on_floor(), pose);
  for (Index v = 0; v < image.camera.height; ++v) {
    for (Index u = 100; u < 110; ++u) image.frame.depth[v * image.camera.width + u] = 0.0F;
  }
  const ViewScene view = view_scene({image.frame, image.camera});
  ASSERT_TRUE(view.built.scene.occupancy);
  const OccupancyGrid grid =
      rasterize(*view.built.scene.occupancy, bounding_box(view.built.scene.cloud.positions));
  std::size_t i = 0, free = 0, behind = 0, in_hole = 0;
  for (int z = 0; z < grid.frame.size.z(); ++z) {
    for (int y = 0; y < grid.frame.size.y(); ++y) {
      for (int x = 0; x < grid.frame.size.x(); ++x, ++i) {
        if (grid.states[i] != VoxelState::free) continue;
        ++free;
        const Eigen::Vector3f at =
            grid.frame.origin +
            grid.frame.resolution * (Eigen::Vector3f(static_cast<float>(x), static_cast<float>(y),
                                                     static_cast<float>(z))
                                         .array() +
                                     0.5F)
                                        .matrix();
        const Eigen::Vector2d pixel = image.camera.project(at.cast<double>());
        const auto u = static_cast<Index>(std::lround(pixel.x()));
        const auto v = static_cast<Index>(std::lround(pixel.y()));
        if (u >= image.camera.width || v >= image.camera.height) continue;
        const float depth = image.frame.depth[v * image.camera.width + u];
        behind += depth > 0.0F && at.z() > depth ? 1 : 0;
        in_hole += u > 102 && u < 107 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(free, 1000U);
  EXPECT_EQ(behind, 0U);
  EXPECT_EQ(in_hole, 0U);
}

TEST(ViewScene, IsTheSameForAnyNumberOfThreads) {
  const Image image = render(table_on_floor(), looking_at({0, -1, 1.6}, {0, 0, 0.8}), noise);
  const auto run = [&] { return view_scene({image.frame, image.camera}); };
  const ViewScene one = testing::with_threads(1, run), two = testing::with_threads(2, run);
  EXPECT_EQ(one.points.cloud.normals, two.points.cloud.normals);
  EXPECT_EQ(one.built.scene.cloud.positions, two.built.scene.cloud.positions);
}

TEST(ViewScene, MovesWithTheCameraAndKeepsThePointsInItsFrame) {
  const Image image = render(table_on_floor(), looking_at({0, -1, 1.6}, {0, 0, 0.8}), noise);
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.rotate(Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized()));
  T_world_camera.pretranslate(Eigen::Vector3d(0.3, -0.2, -2.0));
  const ViewScene at_origin = view_scene({image.frame, image.camera});
  const ViewScene placed = view_scene({image.frame, image.camera, T_world_camera});
  EXPECT_EQ(placed.points.cloud.positions, at_origin.points.cloud.positions);
  EXPECT_EQ(view_mesh(placed.points).triangles, view_mesh(at_origin.points).triangles);
  const auto center = [](const ViewScene& scene) -> Eigen::Vector3d {
    return scene.built.scene.cloud.positions.colwise().mean().transpose().cast<double>();
  };
  EXPECT_LT((center(placed) - T_world_camera * center(at_origin)).norm(), 0.01);
}

TEST(ViewScene, RefusesBadInput) {
  const Image image = render(table_on_floor(), looking_at({0, -1, 1.6}, {0, 0, 0.8}));
  CameraIntrinsics other = image.camera;
  other.width = 80;
  EXPECT_THROW(view_scene({image.frame, other}), InputError);
  other = image.camera;
  other.fx = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(view_scene({image.frame, other}), InputError);
  DepthFrame empty;
  empty.depth.assign(image.camera.pixels(), 0.0F);
  EXPECT_THROW(view_scene({empty, image.camera}), InputError);
  ViewPointOptions options;
  options.max_depth = 0.1;
  EXPECT_THROW(options.validate(), InputError);
}

}  // namespace
}  // namespace symscene
