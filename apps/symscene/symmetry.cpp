#include <algorithm>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.hpp"
#include "core/naming.hpp"
#include "core/number_in.hpp"
#include "io/atomic_file.hpp"
#include "models.hpp"
#include "session.hpp"
#include "symmetry/greatest_distance.hpp"
#include "symmetry_formats.hpp"
#include "symmetry_review.hpp"
#include "symscene/io/cloud.hpp"
#include "symscene/io/mesh.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A model as points of even density with normals, and the points that give its extent.
struct Model {
  std::string name;
  PointCloud surface;
  TriangleMesh mesh;  ///< of a cloud only its points, as vertices
};

Model model_of(const NamedMesh& named) {
  return {named.name, even_surface(named.mesh), named.mesh};
}

/// The number in a name like obj_000012; 0 in others.
int bop_number(const std::string& name) {
  constexpr std::string_view prefix = "obj_";
  if (!name.starts_with(prefix)) return 0;
  return std::max(number_in<int>(name.substr(prefix.size())).value_or(0), 0);
}

/// A list in a sentence: of a long one its ends.
std::string shortened(std::vector<std::string> items) {
  constexpr std::size_t shown = 4;
  if (items.size() > shown) {
    items[1] = "...";
    items.erase(items.begin() + 2, items.end() - 1);
  }
  return fmt::format("{}", fmt::join(items, ", "));
}

struct Symmetry {
  SharedOptions shared;
  SymmetryGroupOptions whole;
  SingleObjectOptions partial;
  std::vector<fs::path> inputs;
  fs::path review, reviewed;
  std::string format = "json", units = "m";
  bool is_partial = false;

  OptionFields configure() {
    return is_partial ? configure_options(partial, shared.config)
                      : configure_options(whole, shared.config);
  }

  void run() {
    configure();
    refuse_contradictions();
    Session session("symmetry", shared);
    StageTimer timer(session.on_begin());
    const std::vector<Model> models = timer.time("read", [&] { return read_models(session); });
    std::optional<ReviewChoices> choices;  // read before the search, which takes longer
    if (!reviewed.empty()) choices.emplace(reviewed);
    if (!(review.empty() && reviewed.empty())) require_different_names(models);
    Json list = Json::array();
    std::vector<ModelSymmetries> groups;
    timer.time("detect", [&] {
      for (const Model& model : models) {
        naming(model.name, [&] {
          if (is_partial) {
            list.push_back(
                partial_json(model.name, detect_object_symmetries(model.surface, partial)));
          } else {
            groups.push_back(symmetries_of(model));
          }
        });
      }
    });
    if (choices) apply_choices(*choices, groups, session);
    for (const ModelSymmetries& group : groups) list.push_back(group_json(group));
    if (!review.empty()) write_review(models, groups, session);
    if (review.empty() || !shared.output.empty())
      write(format == "bop" ? models_info(groups, session) : Json{{"version", 2}, {"models", list}},
            session);
    session.finish({{"output", shared.output.empty() ? review : shared.output},
                    {"count", models.size()},
                    ReportMember::raw("models", list.dump())},
                   timer.stages());
  }

 private:
  void refuse_contradictions() const {
    if (format == "bop" && !review.empty() && shared.output.empty())
      throw InputError("--format bop",
                       "-o FILE beside --review (or the choices of the page, with --reviewed)",
                       "no output");
    if (is_partial && format == "bop")
      throw InputError("--format bop", "whole models", "--partial");
    if (is_partial && !(review.empty() && reviewed.empty()))
      throw InputError(review.empty() ? "--reviewed" : "--review", "whole models", "--partial");
    require_apart({shared.output, review}, inputs);
    require_apart({shared.output, review}, {reviewed});
  }

  static void apply_choices(const ReviewChoices& choices, std::vector<ModelSymmetries>& groups,
                            Session& session) {
    for (ModelSymmetries& group : groups) session.warn(choices.apply(group));
  }

  /// Choices are told apart by the names of the models.
  void require_different_names(const std::vector<Model>& models) const {
    std::set<std::string> names;
    for (const Model& model : models) {
      if (!names.insert(model.name).second)
        throw InputError(review.empty() ? "--reviewed" : "--review", "models of different names",
                         "two of " + model.name);
    }
  }

  void write_review(const std::vector<Model>& models, const std::vector<ModelSymmetries>& groups,
                    Session& session) const {
    std::vector<ReviewedModel> shown;
    for (std::size_t k = 0; k < models.size(); ++k)
      shown.push_back(reviewed_model(groups[k], models[k].mesh));
    const std::string title = models.size() == 1
                                  ? "Symmetries of " + models.front().name
                                  : fmt::format("Symmetries of {} models", models.size());
    write_file_atomically(review, render_review_page(shown, title));
    session.print_line(review.string());
  }

  std::vector<Model> read_models(Session& session) const {
    std::vector<Model> models;
    for (const fs::path& input : inputs) {
      if (fs::is_directory(input)) {
        const MeshFolder folder = read_mesh_folder(input);
        session.warn(folder.warnings);
        for (const NamedMesh& mesh : folder.meshes) models.push_back(model_of(mesh));
      } else if (is_cloud_file(input)) {
        const PointCloud cloud = read_cloud(input);
        models.push_back({input.stem().string(), cloud, {}});
        models.back().mesh.vertices = cloud.positions;
      } else {
        models.push_back(model_of({input.stem().string(), read_mesh(input)}));
      }
      if (!is_partial && is_cloud_file(input)) {
        PointCloud& surface = models.back().surface;
        surface = naming(input, [&] { return even_surface(surface); });
      }
    }
    return models;
  }

  /// The benchmark's models are of 5 mm to 5 m: others have another unit.
  void warn_of_unit(const std::vector<ModelSymmetries>& models, Session& session) const {
    constexpr double least = 5.0, most = 5000.0;  // [mm]
    std::vector<std::string> doubtful;
    for (const ModelSymmetries& model : models) {
      const double diameter = model.diameter * model.millimetres;
      if (diameter < least || diameter > most)
        doubtful.push_back(fmt::format("{} ({:.3g} mm)", model.name, diameter));
    }
    if (!doubtful.empty())
      session.warn(fmt::format(
          "diameters show another unit than {}: {}: --units names the unit of the models", units,
          shortened(doubtful)));
  }

  ModelSymmetries symmetries_of(const Model& model) const {
    const Points& vertices = model.mesh.vertices;
    return {model.name, units == "mm" ? 1.0 : 1000.0, bounding_box(vertices),
            greatest_distance(vertices), find_symmetry_group(model.surface, whole)};
  }

  /// models_info.json: entries by the numbers of obj_NNNNNN, or in order.
  Json models_info(const std::vector<ModelSymmetries>& models, Session& session) const {
    std::set<int> numbers;
    for (const ModelSymmetries& model : models) numbers.insert(bop_number(model.name));
    const bool are_numbered = numbers.size() == models.size() && !numbers.contains(0);
    Json json;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < models.size(); ++k) {
      const int number = are_numbered ? bop_number(models[k].name) : static_cast<int>(k) + 1;
      names.push_back(fmt::format("{} is {}", number, models[k].name));
      json[std::to_string(number)] = bop_json(models[k]);
    }
    if (!are_numbered)
      session.warn("models are numbered in order, as not all names are like obj_000001: " +
                   shortened(names));
    warn_of_unit(models, session);
    return json;
  }

  /// Writes the file or, without one, standard output, unless --json prints the same there.
  void write(const Json& json, Session& session) const {
    const std::string text = format == "yaml" ? format_yaml(json) : format_json(json);
    if (!shared.output.empty()) {
      write_file_atomically(shared.output, text);
      session.print_line(shared.output.string());
    } else if (!shared.json) {
      session.print(text);
    }
  }
};

}  // namespace

void add_symmetry(CommandLine& line) {
  const auto state = std::make_shared<Symmetry>();
  Arguments arguments(line, "symmetry",
                      "Find the symmetry groups of whole models (PLY, OBJ, STL, GLB, PCD)",
                      "symscene symmetry mug.obj -o symmetries.json\n"
                      "  symscene symmetry models --units mm --format bop -o models_info.json\n"
                      "  symscene symmetry models --review review.html\n"
                      "  symscene symmetry models --reviewed choices.json --format bop -o "
                      "models_info.json\n"
                      "  symscene symmetry scan.ply --partial");
  arguments.inputs(state->inputs, "MODEL", "files with a mesh or a point cloud, folders of meshes");
  arguments.optional_output_file(state->shared, "file to write (default: standard output)");
  arguments.choice("--format", state->format, {"json", "yaml", "bop"},
                   "format of the output; bop is models_info.json of the BOP benchmark (default " +
                       state->format + ")");
  arguments.choice("--units", state->units, {"m", "mm"},
                   "unit of the models (default " + state->units + ")");
  arguments.file("--review", state->review,
                 "page to write, on which a person accepts or rejects each symmetry and saves the "
                 "choices as a file");
  arguments.file("--reviewed", state->reviewed,
                 "file of such choices: symmetries that were rejected are left out");
  arguments.flag("--partial", state->is_partial,
                 "the model is a partial scan: detect its probable axis and mirror planes");
  arguments.run_stages(state);
  const auto partial = std::make_shared<Symmetry>();
  partial->is_partial = true;
  arguments.config_with("--partial", [partial] { return partial->configure(); });
}

}  // namespace symscene::app
