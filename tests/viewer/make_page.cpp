// Writes pages from C++ for the browser's tests: make_page PAGE.html RUN.html
#include <fstream>
#include <numbers>
#include <vector>

#include "explored_box.hpp"
#include "planned_run.hpp"
#include "symscene/viewer/page.hpp"

namespace {

/// The front half of a can that stands on the table at (x, 0).
void add_can(symscene::SegmentationResult& result, float x) {
  constexpr int around = 60;
  constexpr int rows = 40;
  symscene::Points& positions = result.cloud.positions;
  symscene::Points& normals = result.cloud.normals;
  Eigen::Index next = positions.rows();
  positions.conservativeResize(next + around * rows, Eigen::NoChange);
  normals.conservativeResize(next + around * rows, Eigen::NoChange);
  symscene::SceneObject object;
  for (int k = 0; k < around * rows; ++k, ++next) {
    const float angle =
        -std::numbers::pi_v<float> * static_cast<float>(k % around) / static_cast<float>(around);
    normals.row(next) << std::cos(angle), std::sin(angle), 0.0F;
    positions.row(next) << x, 0.0F, 0.003F * static_cast<float>(k / around);
    positions.row(next) += 0.04F * normals.row(next);
    object.points.push_back(static_cast<symscene::Index>(next));
  }
  object.score = 0.9;
  object.centroid = Eigen::Vector3d(x, 0.0, 0.06);
  object.rotational.push_back({{*object.centroid, Eigen::Vector3d::UnitZ()}, 0.01});
  result.objects.push_back(object);
}

/// The table that they stand on, one sheet of 2 cm squares, and the fronts of the cans.
symscene::TriangleMesh surface_of(const symscene::PointCloud& cans, symscene::Index can) {
  constexpr symscene::Index side = 40;
  symscene::TriangleMesh mesh;
  const auto first = static_cast<symscene::Index>(cans.positions.rows());
  mesh.vertices.resize(first + side * side, 3);
  mesh.vertices.topRows(first) = cans.positions;
  for (symscene::Index i = 0; i < side * side; ++i) {
    mesh.vertices.row(first + i) << 0.02F * static_cast<float>(i % side) - 0.4F,
        0.02F * static_cast<float>(i / side) - 0.4F, 0.0F;
  }
  std::vector<symscene::Index> corners;
  const auto add_sheet = [&](symscene::Index begin, symscene::Index columns, symscene::Index rows) {
    for (symscene::Index i = 0; i + 1 < rows; ++i) {
      for (symscene::Index k = 0; k + 1 < columns; ++k) {
        const symscene::Index a = begin + i * columns + k, b = a + columns;
        corners.insert(corners.end(), {a, a + 1, b + 1, a, b + 1, b});
      }
    }
  };
  add_sheet(first, side, side);
  for (symscene::Index begin = 0; begin < first; begin += can) add_sheet(begin, 60, can / 60);
  mesh.triangles = Eigen::Map<decltype(mesh.triangles)>(
      corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
  return mesh;
}

symscene::Trajectory path_before(float distance) {
  symscene::Trajectory path(20);
  for (std::size_t i = 0; i < path.size(); ++i) {
    path[i].T_world_camera.translation() << 0.03 * static_cast<double>(i) - 0.3, -distance, 0.4;
  }
  return path;
}

/// A grasp of every can from above, and one that would hit the table.
symscene::PageGrasps grasps_of(const symscene::SegmentationResult& cans) {
  symscene::PageGrasps grasps;
  grasps.gripper.name = "two fingers";
  for (std::size_t id = 0; id < cans.objects.size(); ++id) {
    symscene::Grasp grasp;
    grasp.object = static_cast<int>(id);
    grasp.T_world_tool.linear().diagonal() << 1.0, -1.0, -1.0;
    grasp.T_world_tool.translation() = *cans.objects[id].centroid;
    grasp.T_world_tool.translation().z() += 0.07;
    grasp.opening = 0.08;
    grasp.quality = 0.9 - 0.3 * static_cast<double>(id);
    grasps.plan.grasps.push_back(grasp);
    grasp.T_world_tool.translation().z() = 0.0;
    grasps.plan.rejected.push_back({grasp, symscene::GraspRejection::table, -0.05, 0.002});
    symscene::ObjectGraspSummary summary;
    summary.candidates = 2;
    summary.grasps = 1;
    summary.rejected[static_cast<std::size_t>(symscene::GraspRejection::table)] = 1;
    grasps.plan.objects.push_back(summary);
  }
  return grasps;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  symscene::SegmentationResult result;
  for (const float x : {-0.12F, 0.0F, 0.12F}) add_can(result, x);
  result.timings.push_back({"rotational", 0.02});
  std::ofstream(argv[1], std::ios::binary)
      << symscene::render_page(result, {.title = "Three cans",
                                        .table = symscene::Plane{},
                                        .surface = surface_of(result.cloud, 60 * 40),
                                        .trajectory = path_before(0.7F),
                                        .grasps = grasps_of(result)});
  symscene::write_run_page(argv[2], symscene::carried_box(), "One box");
  std::ofstream(argv[3], std::ios::binary)
      << symscene::render_plan_page(symscene::planned_box(), "A plan");
  std::ofstream(argv[4], std::ios::binary)
      << symscene::render_exploration_page(symscene::explored_box(), "One box");
}
