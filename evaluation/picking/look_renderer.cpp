#include "look_renderer.hpp"

#include "core/random.hpp"
#include "core/rigid_motion.hpp"
#include "simulation/tabletop_meshes.hpp"

namespace symscene {
namespace {

constexpr Index of_robot = SensorFrame::nothing - 1;
constexpr std::uint8_t brightness = 120;  // of robot and bin

TriangleMesh painted(TriangleMesh mesh) {
  mesh.colors = Colors::Constant(mesh.vertices.rows(), 3, brightness);
  return mesh;
}

/// Draws what is nearer in `front` over `frame`.
void draw_over(const SensorFrame& front, SensorFrame& frame) {
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const bool is_hidden = frame.depth[i] > 0.0F && frame.depth[i] <= front.depth[i];
    if (front.depth[i] == 0.0F || is_hidden) continue;
    const auto row = static_cast<Eigen::Index>(i);
    frame.depth[i] = front.depth[i];
    frame.objects[i] = of_robot;
    frame.cosines[i] = front.cosines[i];
    frame.colors.row(row) = front.colors.row(row);
  }
}

}  // namespace

LookRenderer::LookRenderer(const Tabletop& tabletop, const RobotSolids& robot,
                           const TriangleMesh& bin, const SimulatedPickOptions& options)
    : robot_(robot),
      bin_(bin),
      options_(options),
      camera_(options.look.intrinsics()),
      table_(tabletop_meshes(tabletop)) {}

LookImage LookRenderer::render(const CameraMoment& moment, std::uint64_t stream) const {
  std::vector<TriangleMesh> solids{painted(bin_)};
  for (std::size_t i = 0; i < robot_.solids().size(); ++i)
    solids.push_back(painted(transformed(robot_.solids()[i].mesh, moment.solids[i])));
  SensorFrame exact = table_.render(camera_, moment.T_table_camera);
  draw_over(DepthRenderer(solids).render(camera_, moment.T_table_camera), exact);
  SensorFrame seen =
      add_sensor_noise(exact, camera_, options_.sensor, Random(options_.seed, stream));
  std::size_t covered = 0;
  for (std::size_t i = 0; i < seen.depth.size(); ++i) {
    if (seen.objects[i] != of_robot) continue;
    seen.depth[i] = 0.0F;
    ++covered;
  }
  const double share = static_cast<double>(covered) / static_cast<double>(seen.depth.size());
  return {{moment.time, std::move(seen.depth), std::move(seen.colors)}, share};
}

}  // namespace symscene
