// The symmetry groups of scanned models against symmetries that an exhaustive search found.
#include <chrono>
#include <fstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/surface_sampling.hpp"
#include "program.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/mesh.hpp"
#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene {
namespace {

constexpr std::size_t sampled_points = 20000;
const double max_angle = radians(5.0);
constexpr double max_distance = 0.02;  ///< by the diagonal

template <class Symmetry>
struct Known {
  Symmetry symmetry;
  bool strict = false;  ///< the others are neither right nor wrong
};

struct KnownModel {
  double diagonal = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  std::vector<Known<RotationAxis>> axes;
  std::vector<Known<ReflectionPlane>> planes;
};

Eigen::Vector3d vector_of(const nlohmann::json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

KnownModel known_model(const nlohmann::json& json) {
  KnownModel model{json.at("diag"), vector_of(json.at("centroid")), {}, {}};
  for (const auto& axis : json.at("rot"))
    model.axes.push_back({{vector_of(axis.at("p")), vector_of(axis.at("d"))}, axis.at("strict")});
  for (const auto& plane : json.at("refl"))
    model.planes.push_back(
        {{vector_of(plane.at("p")), vector_of(plane.at("n"))}, plane.at("strict")});
  return model;
}

/// Right and wrong ones of what was found, and of what is known.
struct Counts {
  int right = 0, wrong = 0, found = 0, missed = 0;

  std::string text() const {
    const auto share = [](int a, int b) { return a + b == 0 ? 1.0 : double(a) / (a + b); };
    return fmt::format("precision {:.3f} ({} wrong), recall {:.3f} ({} missed)",
                       share(right, wrong), wrong, share(found, missed), missed);
  }
};

class Comparison {
 public:
  explicit Comparison(const KnownModel& known) : known_(known) {}

  template <class A, class B>
  bool same(const A& a, const B& b) const {
    const SymmetryDifference apart = difference(a, b, known_.centroid);
    return apart.angle < max_angle && apart.distance < max_distance * known_.diagonal;
  }

  /// Counts the symmetries of a group. Returns those that are wrong or missed.
  std::string add(const SymmetryGroup& group, Counts& axes, Counts& planes) const {
    std::vector<RotationAxis> turning;
    for (const GroupAxis& found : group.axes) {
      if (found.order == GroupAxis::continuous) turning.push_back(found.axis);
    }
    return count_found(group, turning, axes, planes) + count_known(group, turning, axes, planes);
  }

 private:
  static std::string note(const SymmetryGroup& group, const char* what, double residual) {
    return fmt::format("  {} {:.1f} %", what, 100 * residual / group.diagonal);
  }

  std::string count_found(const SymmetryGroup& group, const std::vector<RotationAxis>& turning,
                          Counts& axes, Counts& planes) const {
    std::string text;
    for (const RotationAxis& axis : turning) {
      const bool right = std::any_of(known_.axes.begin(), known_.axes.end(),
                                     [&](const auto& known) { return same(axis, known.symmetry); });
      ++(right ? axes.right : axes.wrong);
      if (!right) text += note(group, "axis not known", group.axes.front().residual);
    }
    for (const GroupPlane& found : group.planes) {
      const bool right = holds(found.plane);
      ++(right ? planes.right : planes.wrong);
      if (!right) text += note(group, "plane not known", found.residual);
    }
    return text;
  }

  std::string count_known(const SymmetryGroup& group, const std::vector<RotationAxis>& turning,
                          Counts& axes, Counts& planes) const {
    std::string text;
    for (const auto& known : known_.axes) {
      if (!known.strict) continue;
      const bool seen =
          group.sphere || std::any_of(turning.begin(), turning.end(),
                                      [&](const auto& axis) { return same(axis, known.symmetry); });
      ++(seen ? axes.found : axes.missed);
      if (!seen) text += "  axis missed";
    }
    for (const auto& known : known_.planes) {
      if (!known.strict) continue;
      const bool seen =
          group.sphere ||
          std::any_of(turning.begin(), turning.end(),
                      [&](const auto& axis) { return same(known.symmetry, axis); }) ||
          std::any_of(group.planes.begin(), group.planes.end(),
                      [&](const auto& found) { return same(found.plane, known.symmetry); });
      ++(seen ? planes.found : planes.missed);
      if (!seen) text += "  plane missed";
    }
    return text;
  }

  bool holds(const ReflectionPlane& plane) const {
    return std::any_of(known_.planes.begin(), known_.planes.end(),
                       [&](const auto& known) { return same(plane, known.symmetry); }) ||
           std::any_of(known_.axes.begin(), known_.axes.end(),
                       [&](const auto& known) { return same(plane, known.symmetry); });
  }

  const KnownModel& known_;
};

std::string orders_of(const SymmetryGroup& group) {
  std::string text = group.sphere ? "sphere" : "";
  for (const GroupAxis& found : group.axes)
    text += found.order == GroupAxis::continuous ? "∞ " : fmt::format("{} ", found.order);
  return text;
}

void run(const std::filesystem::path& meshes, const std::filesystem::path& searched) {
  const nlohmann::json all = nlohmann::json::parse(std::ifstream(searched));
  Counts axes, planes;
  double slowest = 0.0, total = 0.0;
  int models = 0;
  for (const NamedMesh& model : read_mesh_folder(meshes).meshes) {
    if (!all.contains(model.name)) continue;
    const KnownModel known = known_model(all.at(model.name));
    const auto start = std::chrono::steady_clock::now();
    const SymmetryGroup group = find_symmetry_group(sample_surface(model.mesh, sampled_points));
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    slowest = std::max(slowest, time.count());
    total += time.count();
    ++models;
    const std::string differences = Comparison(known).add(group, axes, planes);
    fmt::print("{:32} {:.2f} s  {:2} turns  axes {:12} planes {}{}\n", model.name, time.count(),
               group.rotations.size(), orders_of(group), group.planes.size(), differences);
  }
  fmt::print("\n{} models, {:.2f} s each, at most {:.2f} s\ncontinuous axes: {}\nplanes: {}\n",
             models, total / std::max(models, 1), slowest, axes.text(), planes.text());
}

}  // namespace
}  // namespace symscene

int main(int argc, char** argv) {
  CLI::App app("Symmetry groups of whole models against those that an exhaustive search found");
  std::string meshes, searched;
  app.add_option("MESHES", meshes, "folder of meshes")->required();
  app.add_option("SEARCHED", searched, "JSON: by name diag, centroid, rot and refl")->required();
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_model_symmetries", [&] {
    symscene::run(meshes, searched);
    return 0;
  });
}
