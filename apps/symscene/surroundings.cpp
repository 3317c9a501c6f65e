#include "surroundings.hpp"

#include <fmt/format.h>

#include "symscene/io/mesh.hpp"
#include "symscene/io/trajectory.hpp"
#include "symscene/viewer/page_surface.hpp"

namespace symscene::app {
namespace {

/// Reads a file if it exists. An invalid file gives a warning and an empty value.
template <class Value, class Read>
Value read_if_there(const std::filesystem::path& file, Session& session, const Read& read) {
  if (!std::filesystem::exists(file)) return {};
  try {
    return read();
  } catch (const InputError& error) {
    session.warn(fmt::format("{}; it is left out", error.what()));
    return {};
  }
}

}  // namespace

Surroundings scene_surroundings(const std::filesystem::path& scene,
                                const SegmentationResult& result, Session& session) {
  const std::filesystem::path mesh = scene / "mesh.ply";
  const std::filesystem::path poses = scene / "poses.txt";
  const auto shown = [&] {
    const TriangleMesh surface = read_mesh(mesh);
    return naming(mesh, [&] { return page_surface(surface, result); });
  };
  return {read_if_there<TriangleMesh>(mesh, session, shown),
          read_if_there<Trajectory>(poses, session, [&] { return read_trajectory(poses); })};
}

}  // namespace symscene::app
