#include "scene_output.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/naming.hpp"
#include "core/plane_text.hpp"
#include "ground_truth.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/io/table_plane.hpp"
#include "symscene/workflow/reconstructed_scene.hpp"

namespace symscene::app {

void require_folder(const std::filesystem::path& output) {
  if (std::filesystem::exists(output) && !std::filesystem::is_directory(output))
    throw InputError(output.string(), "a folder to write", "a file");
}

void TableArguments::add_to(Arguments& arguments, const char* plane_help) {
  arguments.text("--plane", "A,B,C,D", plane, plane_help);
  arguments.flag("--any-up", any_up,
                 "the camera was not held upright: accept a table of any orientation");
  arguments.flag("--no-table", none,
                 "there is no table (a bin, a shelf, things in a hand): take all that is seen");
}

std::optional<Plane> TableArguments::table() const {
  if (any_up && (none || !plane.empty())) {
    throw InputError("--any-up", fmt::format("no {} beside it", none ? "--no-table" : "--plane"),
                     "both");
  }
  if (plane.empty()) return {};
  if (none) throw InputError("--plane", "no --no-table beside it", "both");
  std::string words = plane;
  std::replace(words.begin(), words.end(), ',', ' ');
  return parse_table_plane(words, "--plane");
}

void print_table(const BuiltScene& built, Session& session) {
  const auto& supports = built.table.planes.supports;
  if (supports.empty()) return;
  session.print_line(fmt::format("table {}: {:.2f} m^2, residual {:.1f} mm",
                                 plane_text(supports.front().plane), supports.front().area,
                                 1e3 * supports.front().residual));
}

void report_table(const BuiltScene& built, Session& session) {
  print_table(built, session);
  session.warn(built.scene.warnings);
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

std::vector<ReportMember> SceneOutput::write(const Reconstruction& reconstruction,
                                             const SurfaceExtractionOptions& extraction,
                                             const SceneSource& source, Session& session,
                                             StageTimer& timer) const {
  const TriangleMesh surface =
      timer.time("extract surface", [&] { return reconstruction.surface(extraction); });
  const BuiltScene built = timer.time("find table", [&] {
    return naming(input, [&] {
      return reconstructed_scene({reconstruction, surface, source.placed.trajectory}, table.told(),
                                 building);
    });
  });
  std::vector<ReportMember> members =
      write({built, reconstruction.occupancy(), surface}, source, session, timer);
  const auto memory = static_cast<std::uint64_t>(reconstruction.bytes());
  session.print_line(fmt::format("model of {:.0f} MB, voxels of {:.1f} mm",
                                 1e-6 * static_cast<double>(memory),
                                 1e3 * reconstruction.voxel_size()));
  members.emplace_back("model_bytes", memory);
  return members;
}

std::vector<ReportMember> SceneOutput::write(const SceneContent& content, const SceneSource& source,
                                             Session& session, StageTimer& timer) const {
  const BuiltScene& built = content.built;
  const TriangleMesh& surface = content.surface;
  report_table(built, session);
  timer.time("write", [&] {
    LogOddsMap log_odds;
    if (!built.scene.cloud.empty()) log_odds = content.occupancy.log_odds(built.region);
    const PosesAndTruth known = poses_and_truth(source.sequence, source.placed);
    write_scene(absolute(output), built.scene,
                {.scene_json = source.scene_json,
                 .truth_json = transferred_truth(input, known, built.scene.cloud, session),
                 .mesh = &surface,
                 .trajectory = &source.placed.trajectory,
                 .camera = &source.sequence.camera(),
                 .log_odds = &log_odds});
  });
  const auto vertices = static_cast<std::uint64_t>(surface.vertices.rows());
  session.print_line(fmt::format("{}: {} points of objects, {} mesh vertices", output.string(),
                                 built.scene.cloud.size(), vertices));
  return {{"points", built.scene.cloud.size()}, {"vertices", vertices}};
}

}  // namespace symscene::app
