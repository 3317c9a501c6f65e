#include <iostream>

#include <symscene/core/geometry.hpp>
#include <symscene/core/neighbors.hpp>
#include <symscene/io/result.hpp>
#include <symscene/pipeline/pipeline.hpp>
#include <symscene/simulation/simulation.hpp>

int main() {
  const symscene::ReflectionPlane mirror{{0.1, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  const Eigen::Vector3d image = mirror.reflect_point({0.3, 0.2, 0.1});
  if (!image.isApprox(Eigen::Vector3d(-0.1, 0.2, 0.1))) return 1;

  symscene::SimulationOptions simulation;
  simulation.tabletop.objects = 1;
  simulation.camera.frames = 6;
  const symscene::Scene scene = symscene::simulate_tabletop(simulation).scene;
  const symscene::SegmentationResult result = symscene::segment_scene(scene);
  std::cout << symscene::format_objects_json(result).size() << " bytes of objects.json\n";
  return result.cloud.empty() ? 1 : 0;
}
