// Segments a scene of its own, a box on a table, with the robot's wing alone.
#include <iostream>

#include <symscene/pipeline/pipeline.hpp>
#include <symscene/viewer/page.hpp>

namespace {

/// Adds a square of points, 5 mm apart, with the normal along `axis`.
void add_face(std::vector<Eigen::Vector3f>& points, std::vector<Eigen::Vector3f>& normals, int axis,
              float side) {
  constexpr int steps = 20;
  constexpr float spacing = 0.005F;
  for (int i = -steps / 2; i <= steps / 2; ++i) {
    for (int k = 0; k <= steps; ++k) {
      Eigen::Vector3f point(0.0F, 0.0F, 0.02F + spacing * static_cast<float>(k));
      point[axis] = side * spacing * steps / 2;
      point[1 - axis] = spacing * static_cast<float>(i);
      points.push_back(point);
      normals.push_back(Eigen::Vector3f::Unit(axis) * side);
    }
  }
}

symscene::Scene box_on_a_table() {
  std::vector<Eigen::Vector3f> points, normals;
  for (const int axis : {0, 1}) {
    for (const float side : {-1.0F, 1.0F}) add_face(points, normals, axis, side);
  }
  symscene::Scene scene;
  scene.cloud.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  scene.cloud.normals.resizeLike(scene.cloud.positions);
  for (std::size_t i = 0; i < points.size(); ++i) {
    scene.cloud.positions.row(static_cast<Eigen::Index>(i)) = points[i];
    scene.cloud.normals.row(static_cast<Eigen::Index>(i)) = normals[i];
  }
  scene.table = symscene::Plane{Eigen::Vector3d::UnitZ(), 0.0};
  return scene;
}

}  // namespace

int main() {
  const symscene::SegmentationResult result = symscene::segment_scene(box_on_a_table());
  std::cout << result.cloud.size() << " points, " << result.objects.size() << " objects\n";
  return result.cloud.empty() ? 1 : 0;
}
