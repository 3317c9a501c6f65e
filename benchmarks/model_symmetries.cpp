// The symmetry groups of scanned models: their exact residuals, and what an exhaustive search and a
// person found.
#include <chrono>
#include <fstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "annotated_symmetries.hpp"
#include "core/surface_sampling.hpp"
#include "moved_mesh.hpp"
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

/// Exact residuals of all that is listed.
struct Residuals {
  int all = 0, above = 0;
  double worst = 0.0;  ///< by the diagonal

  void add(double residual, double diagonal) {
    constexpr double bound = 0.01;
    ++all;
    above += residual > bound * diagonal ? 1 : 0;
    worst = std::max(worst, residual / diagonal);
  }
  void add(const SymmetryGroup& group, const bench::MovedMesh& mesh) {
    for (const GroupAxis& found : group.axes)
      add(mesh.residual(found.axis, found.order), group.diagonal);
    for (const GroupPlane& found : group.planes) add(mesh.residual(found.plane), group.diagonal);
  }
};

struct Input {
  std::string meshes, searched, annotated;
};

/// What is counted over all models.
class Benchmark {
 public:
  explicit Benchmark(const Input& input) {
    if (!input.searched.empty()) searched_ = nlohmann::json::parse(std::ifstream(input.searched));
    if (!input.annotated.empty()) annotated_ = bench::read_annotated_models(input.annotated);
  }

  void add(const NamedMesh& model) {
    const auto start = std::chrono::steady_clock::now();
    const SymmetryGroup group = find_symmetry_group(sample_surface(model.mesh, sampled_points));
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    slowest_ = std::max(slowest_, time.count());
    total_ += time.count();
    ++models_;
    fmt::print("{:32} {:.2f} s  {:2} turns  axes {:12} planes {}{}\n", model.name, time.count(),
               group.rotations.size(), orders_of(group), group.planes.size(),
               differences(model.name, group));
    const bench::MovedMesh moved(model.mesh);
    residuals_.add(group, moved);
    for (const bench::AnnotatedModel& each : annotated_) {
      if (model.name.starts_with(each.number + "_"))
        comparisons_ += compare_with_annotation(each, model.name, moved, group, annotation_counts_);
    }
  }

  void print() const {
    fmt::print("\n{} models, {:.2f} s each, at most {:.2f} s\n", models_,
               total_ / std::max(models_, 1), slowest_);
    fmt::print("exact residuals: {} of {} above 1 % of the diagonal, at most {:.2f} %\n",
               residuals_.above, residuals_.all, 100.0 * residuals_.worst);
    if (!searched_.is_null())
      fmt::print("continuous axes: {}\nplanes: {}\n", axes_.text(), planes_.text());
    if (!annotated_.empty())
      fmt::print(
          "\nannotated, and the nearest that is found: angle, distance at the centroid\n{}{} "
          "annotated, {} found within 1°, {} of them within 1 % of the diagonal; {} have a smaller "
          "residual than what is found\n",
          comparisons_, annotation_counts_.all, annotation_counts_.near_angle,
          annotation_counts_.near, annotation_counts_.annotation_better);
  }

 private:
  std::string differences(const std::string& name, const SymmetryGroup& group) {
    if (!searched_.contains(name)) return "";
    const KnownModel known = known_model(searched_.at(name));
    return Comparison(known).add(group, axes_, planes_);
  }

  nlohmann::json searched_;
  std::vector<bench::AnnotatedModel> annotated_;
  Counts axes_, planes_;
  Residuals residuals_;
  bench::AnnotationCounts annotation_counts_;
  std::string comparisons_;
  double slowest_ = 0.0, total_ = 0.0;  ///< [s]
  int models_ = 0;
};

void run(const Input& input) {
  Benchmark benchmark(input);
  for (const NamedMesh& model : read_mesh_folder(input.meshes).meshes) benchmark.add(model);
  benchmark.print();
}

}  // namespace
}  // namespace symscene

int main(int argc, char** argv) {
  CLI::App app("Symmetry groups of whole models: exact residuals, and what is known of them");
  symscene::Input input;
  app.add_option("MESHES", input.meshes, "folder of meshes")->required();
  app.add_option("SEARCHED", input.searched,
                 "JSON of an exhaustive search: by name diag, centroid, rot and refl");
  app.add_option("--annotated", input.annotated,
                 "symmetries that a person saw in 20 objects of the YCB set: blocks of five lines");
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_model_symmetries", [&] {
    symscene::run(input);
    return 0;
  });
}
