#include "scene_output.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "symscene/io/scene.hpp"
#include "symscene/io/table_plane.hpp"
#include "symscene/io/truth.hpp"
#include "symscene/simulation/truth_transfer.hpp"

namespace symscene::app {
namespace {

std::string plane_numbers(const Plane& plane) {
  return fmt::format("{:.4f},{:.4f},{:.4f},{:.4f}", plane.normal.x(), plane.normal.y(),
                     plane.normal.z(), plane.offset);
}

void report_table(const std::filesystem::path& input, const TableScene& table, Session& session) {
  if (table.planes.supports.empty()) {
    std::vector<std::string> found;
    for (const SupportPlane& other : table.planes.others) {
      found.push_back(fmt::format("{} ({:.2f} m^2)", plane_numbers(other.plane), other.area));
    }
    throw InputError(
        input.string(), "a table with objects on it (or --plane a,b,c,d)",
        found.empty() ? "no plane" : fmt::format("only the planes {}", fmt::join(found, "; ")));
  }
  const auto& supports = table.planes.supports;
  session.print_line(fmt::format("table {}: {:.2f} m^2, residual {:.1f} mm",
                                 plane_numbers(supports.front().plane), supports.front().area,
                                 1e3 * supports.front().residual));
  for (std::size_t k = 1; k < supports.size(); ++k) {
    session.warn(fmt::format("another plane also has objects on it: --plane {} ({:.2f} m^2)",
                             plane_numbers(supports[k].plane), supports[k].area));
  }
}

/// The ground truth of a simulated sequence, transferred to the frame and points of the scene.
std::optional<SceneTruth> scene_truth(const std::filesystem::path& input,
                                      const DepthSequence& sequence, const PlacedFrames& placed,
                                      const PointCloud& cloud) {
  if (!std::filesystem::exists(input / "truth.json")) return {};
  const PosesAndTruth known = poses_and_truth(sequence, placed);
  const SceneTruth truth = read_truth(input / "truth.json");
  return transfer_truth(truth, read_truth_meshes(input, truth), cloud,
                        align_poses(known.poses, known.truth));
}

}  // namespace

void require_folder(const std::filesystem::path& output) {
  if (std::filesystem::exists(output) && !std::filesystem::is_directory(output))
    throw InputError(output.string(), "a folder to write", "a file");
}

void TableArguments::add_to(Arguments& arguments, const char* plane_help) {
  arguments.text("--plane", plane, plane_help);
  arguments.flag("--any-up", any_up,
                 "the camera was not held upright: accept a table of any orientation");
}

std::optional<Plane> TableArguments::table() const {
  if (plane.empty()) return {};
  std::string words = plane;
  std::replace(words.begin(), words.end(), ',', ' ');
  return parse_table_plane(words, "--plane");
}

PosesAndTruth poses_and_truth(const DepthSequence& sequence, const PlacedFrames& placed) {
  PosesAndTruth known;
  for (std::size_t k = 0; k < placed.frames.size(); ++k) {
    const auto pose = sequence.pose(placed.frames[k]);
    if (!pose) continue;
    known.poses.push_back(placed.trajectory[k].T_world_camera);
    known.truth.push_back(*pose);
  }
  return known;
}

std::vector<ReportMember> SceneOutput::write(const ReconstructedSequence& made, Session& session,
                                             StageTimer& timer) const {
  const TriangleMesh surface =
      timer.time("extract surface", [&] { return made.reconstruction.surface(extraction); });
  const BuiltScene built = timer.time("find table", [&] {
    return naming(input, [&] {
      return build_scene(surface, made.reconstruction.occupancy(), table,
                         any_up ? std::nullopt : upward(made.placed.trajectory), building);
    });
  });
  report_table(input, built.table, session);
  if (built.scene.cloud.empty())
    throw InputError(input.string(), "objects on the table", "a bare table");
  timer.time("write", [&] {
    const auto truth = scene_truth(input, made.sequence, made.placed, built.scene.cloud);
    write_scene(absolute(output), built.scene,
                {.scene_json = made.scene_json,
                 .truth = truth ? &*truth : nullptr,
                 .mesh = &surface,
                 .trajectory = &made.placed.trajectory,
                 .log_odds = &built.log_odds});
  });
  const auto vertices = static_cast<std::uint64_t>(surface.vertices.rows());
  const auto memory = static_cast<std::uint64_t>(made.reconstruction.bytes());
  session.print_line(fmt::format("{}: {} points of objects, {} mesh vertices, model of {:.0f} MB",
                                 output.string(), built.scene.cloud.size(), vertices,
                                 1e-6 * static_cast<double>(memory)));
  return {{"points", built.scene.cloud.size()}, {"vertices", vertices}, {"model_bytes", memory}};
}

}  // namespace symscene::app
