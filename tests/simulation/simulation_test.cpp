#include "symscene/simulation/simulation.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "core/random.hpp"
#include "simulation/depth_renderer.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/neighbors.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

/// Smaller images than a real sensor's keep the tests short, and fewer where sanitizers make each
/// ten times slower.
SimulationOptions small_scan(std::uint64_t seed, int objects) {
  SimulationOptions options;
  options.tabletop.seed = seed;
  options.tabletop.objects = objects;
  options.camera.frames = 10;
  options.camera.width = 480;
  options.camera.height = 360;
  options.camera.focal_length = 394.0;
#ifdef SYMSCENE_SANITIZED
  options.tabletop.objects = std::min(objects, 3);
  options.camera.frames = 5;
  options.margin = 0.1;
#endif
  return options;
}

template <class Matrix>
bool same_bytes(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(*a.data())) ==
             0;
}

bool same(const SimulatedScene& a, const SimulatedScene& b) {
  if (!same_bytes(a.scene.cloud.positions, b.scene.cloud.positions) ||
      !same_bytes(a.scene.cloud.normals, b.scene.cloud.normals) ||
      !same_bytes(a.scene.cloud.colors, b.scene.cloud.colors) ||
      a.truth.objects.size() != b.truth.objects.size() ||
      a.scene.occupancy->leaves.size() != b.scene.occupancy->leaves.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.truth.objects.size(); ++i) {
    if (a.truth.objects[i].points != b.truth.objects[i].points) return false;
  }
  for (std::size_t i = 0; i < a.scene.occupancy->leaves.size(); ++i) {
    const OccupancyLeaf& x = a.scene.occupancy->leaves[i];
    const OccupancyLeaf& y = b.scene.occupancy->leaves[i];
    if (x.key != y.key || x.level != y.level || x.state != y.state) return false;
  }
  return true;
}

/// How far a point is from a mesh.
double distance_to_mesh(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  double nearest = 1e9;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return mesh.vertices.row(mesh.triangles(t, k)).transpose().cast<double>();
    };
    const Eigen::Vector3d a = corner(0), e1 = corner(1) - a, e2 = corner(2) - a, d = p - a;
    // Edges are a few millimetres: the clamped projection is near enough to the nearest point.
    const double d11 = e1.dot(e1), d12 = e1.dot(e2), d22 = e2.dot(e2);
    const double det = d11 * d22 - d12 * d12;
    if (det < 1e-18) continue;
    double u = std::clamp((d22 * d.dot(e1) - d12 * d.dot(e2)) / det, 0.0, 1.0);
    double v = std::clamp((d11 * d.dot(e2) - d12 * d.dot(e1)) / det, 0.0, 1.0);
    if (u + v > 1.0) {
      const double over = 0.5 * (u + v - 1.0);
      u -= over;
      v -= over;
    }
    nearest = std::min(nearest, (d - u * e1 - v * e2).norm());
  }
  return nearest;
}

TEST(DepthRenderer, SeesABoxWhereItIs) {
  Eigen::Isometry3d away = Eigen::Isometry3d::Identity();
  away.pretranslate(Eigen::Vector3d(0, 0, 0.8));
  const TriangleMesh meshes[] = {transformed(make_box({0.2, 0.2, 0.4}, 0.1), away)};
  const CameraIntrinsics camera{64, 48, 50, 50, 31.5, 23.5};
  const SensorFrame frame = DepthRenderer(meshes).render(camera, Eigen::Isometry3d::Identity());
  const std::size_t middle = 24 * 64 + 32;
  EXPECT_NEAR(frame.depth[middle], 0.8, 1e-6);
  EXPECT_EQ(frame.objects[middle], 0U);
  EXPECT_GT(frame.cosines[middle], 0.99F);
  EXPECT_EQ(frame.depth[0], 0.0F);
  EXPECT_EQ(frame.objects[0], SensorFrame::nothing);
}

TEST(SensorNoise, HasTheDeviationOfItsModelAndItsSteps) {
  const CameraIntrinsics camera{200, 200, 525, 525, 99.5, 99.5};
  SensorFrame flat;
  flat.depth.assign(camera.pixels(), 1.5F);
  flat.objects.assign(camera.pixels(), 0);
  flat.cosines.assign(camera.pixels(), 1.0F);
  flat.colors = Colors::Zero(200 * 200, 3);
  SensorNoiseOptions options;
  options.disparity_step = 0.0;
  const SensorFrame noisy = add_sensor_noise(flat, camera, options, Random(5));
  double sum = 0.0, squares = 0.0;
  for (const float z : noisy.depth) {
    sum += z - 1.5;
    squares += (z - 1.5) * (z - 1.5);
  }
  const double count = static_cast<double>(noisy.depth.size());
  EXPECT_NEAR(sum / count, 0.0, 1e-4);
  EXPECT_NEAR(std::sqrt(squares / count), options.axial * 1.5 * 1.5, 2e-4);

  options.disparity_step = 2.85e-3;
  for (const float z : add_sensor_noise(flat, camera, options, Random(5)).depth) {
    const double steps = 1.0 / (z * options.disparity_step);
    EXPECT_NEAR(steps, std::round(steps), 1e-4);
  }
}

TEST(OctreeLeaves, JoinEightEqualVoxelsAndKeepTheRest) {
  VoxelBlock block;
  block.low = {-2, -2, -2};
  block.size = {4, 2, 2};
  block.states.assign(16, VoxelState::free);
  block.states[2] = VoxelState::occupied;    // x = 0
  block.states[3] = VoxelState::never_seen;  // x = 1
  const OccupancyMap map = to_octree(block, 0.005);
  ASSERT_EQ(map.leaves.size(), 1U + 7U);
  EXPECT_EQ(map.leaves[0].level, 1);
  EXPECT_EQ(map.leaves[0].key, (std::array<std::uint16_t, 3>{32766, 32766, 32766}));
  EXPECT_EQ(map.leaves[1].state, VoxelState::occupied);
  EXPECT_EQ(map.leaves[1].key, (std::array<std::uint16_t, 3>{32768, 32766, 32766}));
}

TEST(Simulation, MasksAreAscendingAndShareNoPoint) {
  const SimulatedScene simulated = simulate_tabletop(small_scan(2, 6));
  std::vector<int> owners(simulated.scene.cloud.size(), 0);
  ASSERT_GE(simulated.truth.objects.size() + 2, simulated.tabletop.objects.size());
  ASSERT_EQ(simulated.truth.objects.size(), simulated.sources.size());
  for (const TrueObject& object : simulated.truth.objects) {
    EXPECT_TRUE(std::is_sorted(object.points.begin(), object.points.end()));
    for (const Index i : object.points) ++owners[i];
  }
  EXPECT_LE(*std::max_element(owners.begin(), owners.end()), 1);
  const auto owned = std::count(owners.begin(), owners.end(), 1);
  EXPECT_GT(static_cast<double>(owned), 0.95 * simulated.scene.cloud.size());
}

TEST(Simulation, TruePointsLieOnTheTrueSurfaceAndFaceOutOfIt) {
  for (const bool random_frame : {false, true}) {
    SimulationOptions options = small_scan(3, 5);
    options.tabletop.random_frame = random_frame;
    const SimulatedScene simulated = simulate_tabletop(options);
    const PointCloud& cloud = simulated.scene.cloud;
    for (std::size_t k = 0; k < simulated.truth.objects.size(); ++k) {
      const TriangleMesh mesh = world_mesh(simulated.tabletop.objects[simulated.sources[k]]);
      const PointIndices& points = simulated.truth.objects[k].points;
      double sum = 0.0;
      int tried = 0, outward = 0;
      for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 60) {
        const Eigen::Vector3d p = cloud.position(points[i]).cast<double>();
        const Eigen::Vector3d n = cloud.normal(points[i]).cast<double>();
        const double distance = distance_to_mesh(mesh, p);
        EXPECT_LT(distance, 0.008) << simulated.truth.objects[k].name;
        EXPECT_NEAR(n.norm(), 1.0, 1e-5);
        sum += distance;
        outward += is_inside(mesh, p + 0.015 * n) ? 0 : 1;
        ++tried;
      }
      EXPECT_LT(sum / tried, 0.002) << simulated.truth.objects[k].name;
      EXPECT_GT(outward, 0.9 * tried) << simulated.truth.objects[k].name;
    }
  }
}

TEST(Simulation, CloudHasOnlyObjectsOnTheTable) {
  SimulationOptions options = small_scan(4, 4);
  options.tabletop.random_frame = true;
  const SimulatedScene simulated = simulate_tabletop(options);
  const PointCloud& cloud = simulated.scene.cloud;
  for (Index i = 0; i < cloud.size(); ++i) {
    EXPECT_GT(simulated.scene.table->signed_distance(cloud.position(i).cast<double>()), 0.002);
  }
}

/// Calls visit(centre) for every voxel of a state.
template <class Visit>
void for_each_voxel(const OccupancyMap& map, VoxelState state, const Visit& visit) {
  for (const OccupancyLeaf& leaf : map.leaves) {
    if (leaf.state != state) continue;
    const int edge = 1 << leaf.level;
    for (int z = 0; z < edge; ++z) {
      for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
          const Eigen::Vector3d key(leaf.key[0] + x, leaf.key[1] + y, leaf.key[2] + z);
          visit(
              Eigen::Vector3d(map.resolution * (key.array() - OccupancyMap::key_of_origin + 0.5)));
        }
      }
    }
  }
}

TEST(Simulation, FreeVoxelsAreOutsideTheTrueSolids) {
  for (const bool random_frame : {false, true}) {
    SimulationOptions options = small_scan(5, 4);
    options.tabletop.random_frame = random_frame;
    const SimulatedScene simulated = simulate_tabletop(options);
    for (const PlacedObject& placed : simulated.tabletop.objects) {
      const Eigen::Isometry3d T_object_world = placed.T_world_object.inverse();
      const TriangleMesh& mesh = placed.object.mesh;
      const Eigen::Vector3d low = mesh.vertices.colwise().minCoeff().transpose().cast<double>();
      const Eigen::Vector3d high = mesh.vertices.colwise().maxCoeff().transpose().cast<double>();
      int tried = 0, inside = 0, counter = 0;
      for_each_voxel(*simulated.scene.occupancy, VoxelState::free, [&](const Eigen::Vector3d& c) {
        const Eigen::Vector3d p = T_object_world * c;
        if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) return;
        if (++counter % 61 != 0) return;
        ++tried;
        inside += is_inside(mesh, p) ? 1 : 0;
      });
      EXPECT_LE(inside, tried / 100) << placed.object.name << " of " << tried;
    }
  }
}

TEST(Simulation, OccupiedVoxelsAreNearSurfacesAndFreeSpaceIsFound) {
  const SimulatedScene simulated = simulate_tabletop(small_scan(6, 3));
  std::size_t free = 0, occupied = 0;
  double highest_over_empty_table = 0.0;
  const Box objects = bounding_box(simulated.scene.cloud.positions).padded(0.02F);
  for_each_voxel(*simulated.scene.occupancy, VoxelState::free,
                 [&](const Eigen::Vector3d&) { ++free; });
  for_each_voxel(*simulated.scene.occupancy, VoxelState::occupied, [&](const Eigen::Vector3d& c) {
    ++occupied;
    const bool beside = (c.cast<float>().array() < objects.min.array()).head<2>().any() ||
                        (c.cast<float>().array() > objects.max.array()).head<2>().any();
    if (beside) highest_over_empty_table = std::max(highest_over_empty_table, std::abs(c.z()));
  });
  EXPECT_GT(free, 20 * occupied);
  EXPECT_GT(occupied, 3000U);
  EXPECT_LT(highest_over_empty_table, 0.009);
}

TEST(Simulation, GivesTheSameBytesForAnyNumberOfThreads) {
  const SimulationOptions options = small_scan(7, 5);
  const auto simulate = [&] { return simulate_tabletop(options); };
  EXPECT_TRUE(same(testing::with_threads(1, simulate), testing::with_threads(8, simulate)));
}

TEST(Simulation, SameSeedSameSceneAndAnotherSeedAnother) {
  EXPECT_TRUE(same(simulate_tabletop(small_scan(8, 3)), simulate_tabletop(small_scan(8, 3))));
  EXPECT_FALSE(same(simulate_tabletop(small_scan(8, 3)), simulate_tabletop(small_scan(9, 3))));
}

TEST(Simulation, ATrueSymmetryMapsTheVisibleSurfaceOntoTheSolidsSurface) {
  SimulationOptions options = small_scan(10, 5);
  options.tabletop.random_frame = true;
  const SimulatedScene simulated = simulate_tabletop(options);
  for (std::size_t k = 0; k < simulated.truth.objects.size(); ++k) {
    const TrueObject& truth = simulated.truth.objects[k];
    const TriangleMesh mesh = world_mesh(simulated.tabletop.objects[simulated.sources[k]]);
    for (std::size_t i = 0; i < truth.points.size(); i += 1 + truth.points.size() / 20) {
      const Eigen::Vector3d p = simulated.scene.cloud.position(truth.points[i]).cast<double>();
      for (const TruePlane& plane : truth.reflectional) {
        EXPECT_LT(distance_to_mesh(mesh, plane.plane.reflect_point(p)), 0.008) << truth.name;
      }
      for (const TrueAxis& axis : truth.rotational) {
        EXPECT_LT(distance_to_mesh(mesh, axis.axis.rotate_point(p, 2.0)), 0.008) << truth.name;
      }
    }
  }
}

}  // namespace
}  // namespace symscene
