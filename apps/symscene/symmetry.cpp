#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/surface_sampling.hpp"
#include "io/atomic_file.hpp"
#include "models.hpp"
#include "session.hpp"
#include "symscene/io/cloud.hpp"
#include "symscene/io/mesh.hpp"
#include "symscene/symmetry/single_object.hpp"

namespace symscene::app {
namespace {

constexpr std::size_t sampled_points = 40000;

nlohmann::ordered_json coordinates(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::ordered_json to_json(const ScoredAxis& found) {
  return {{"point", coordinates(found.axis.point)},
          {"direction", coordinates(found.axis.direction)},
          {"score", found.residual}};
}

nlohmann::ordered_json to_json(const ScoredPlane& found) {
  return {{"point", coordinates(found.plane.point)},
          {"normal", coordinates(found.plane.normal)},
          {"score", found.residual}};
}

template <class Symmetries>
nlohmann::ordered_json list_json(const Symmetries& symmetries) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& found : symmetries) list.push_back(to_json(found));
  return list;
}

/// A list with one entry per line.
std::string format_list(const nlohmann::ordered_json& list) {
  std::string text = "[";
  const char* separator = "\n    ";
  for (const auto& entry : list) text += std::exchange(separator, ",\n    ") + entry.dump();
  return text + "]";
}

std::string format_symmetries(const ObjectSymmetries& found) {
  return fmt::format(
      "{{\n  \"version\": 1,\n  \"sphere\": {},\n  \"centroid\": {},\n  \"rotational\": {},\n"
      "  \"reflectional\": {}\n}}\n",
      found.sphere, coordinates(found.centroid).dump(), format_list(list_json(found.rotational)),
      format_list(list_json(found.reflectional)));
}

struct Symmetry {
  SharedOptions shared;
  SingleObjectOptions options;
  std::filesystem::path model;

  OptionFields configure() { return configure_options(options, shared.config); }

  /// The points of a cloud, or points sampled evenly on a mesh.
  PointCloud read_model() const {
    if (is_cloud_file(model)) return read_cloud(model);
    return sample_surface(read_mesh(model), sampled_points);
  }

  void run() {
    configure();
    if (!shared.output.empty()) require_not_input(shared.output, model);
    Session session("symmetry", shared);
    StageTimer timer(session.on_begin());
    const PointCloud cloud = timer.time("read", [&] { return read_model(); });
    const ObjectSymmetries found = timer.time("detect", [&] {
      return naming(model, [&] { return detect_object_symmetries(cloud, options); });
    });
    write(found, session);
    session.finish({{"output", shared.output},
                    {"points", cloud.size()},
                    ReportMember::raw("sphere", found.sphere ? "true" : "false"),
                    ReportMember::raw("centroid", coordinates(found.centroid).dump()),
                    ReportMember::raw("rotational", list_json(found.rotational).dump()),
                    ReportMember::raw("reflectional", list_json(found.reflectional).dump())},
                   timer.stages());
  }

  /// Writes the file or, without one, standard output, unless --json prints the same there.
  void write(const ObjectSymmetries& found, Session& session) const {
    if (!shared.output.empty()) {
      write_file_atomically(shared.output, format_symmetries(found));
      session.print_line(fmt::format("{}: {} axes, {} planes", shared.output.string(),
                                     found.rotational.size(), found.reflectional.size()));
    } else if (!shared.json) {
      session.print(format_symmetries(found));
    }
  }
};

}  // namespace

void add_symmetry(CommandLine& line) {
  const auto state = std::make_shared<Symmetry>();
  Arguments arguments(line, "symmetry",
                      "Find the symmetries of a single mesh or cloud (PLY, OBJ, STL, GLB, PCD)",
                      "symscene symmetry mug.obj -o symmetries.json");
  arguments.input(state->model, "MODEL", "file with a mesh or a point cloud");
  arguments.optional_output(state->shared, "JSON file to write (default: standard output)");
  arguments.threads(state->shared);
  arguments.reporting(state->shared);
  arguments.config(state->shared, [state] { return state->configure(); });
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
