#include "results.hpp"

#include <fmt/format.h>

#include "core/median.hpp"

namespace symscene::app {
namespace {

std::string plural(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string format_symmetries(const SceneObject& object) {
  std::string text;
  if (!object.rotational.empty()) text = plural(object.rotational.size(), "axis", "axes");
  if (object.reflectional.empty()) return text;
  if (!text.empty()) text += ", ";
  return text + plural(object.reflectional.size(), "plane", "planes");
}

/// "length 21.32 +- 0.08 cm", or "length >= 8.0 cm".
std::string format_dimension(const Dimension& dimension) {
  if (!dimension.sigma)
    return fmt::format("{} >= {:.1f} cm", dimension.name, 100.0 * dimension.value);
  return fmt::format("{} {:.2f} +- {:.2f} cm", dimension.name, 100.0 * dimension.value,
                     100.0 * *dimension.sigma);
}

/// "", or "box: length 21.32 +- 0.08 cm, ...".
std::string format_class(const SceneObject& object) {
  if (!object.symmetry_class || object.symmetry_class->kind == SymmetryClass::none) return "";
  const ObjectClass& found = *object.symmetry_class;
  std::string text = found.kind == SymmetryClass::n_fold ? fmt::format("{}-fold", found.order)
                                                         : std::string(to_string(found.kind));
  const char* separator = ": ";
  for (const Dimension& dimension : found.dimensions) {
    text += separator + format_dimension(dimension);
    separator = ", ";
  }
  return text;
}

}  // namespace

std::string format_objects(const SegmentationResult& result) {
  const bool scored = result.objects.empty() || result.objects.front().score;
  std::string table = fmt::format("{:>3}  {:>6}  {:>5}  {:18}  {}", "id", "points",
                                  scored ? "score" : "confidence", "symmetries", "class");
  for (std::size_t id = 0; id < result.objects.size(); ++id) {
    const SceneObject& object = result.objects[id];
    std::string row = fmt::format("\n{:>3}  {:>6}  {:>5.2f}  {:18}  {}", id, object.points.size(),
                                  object.rank(), format_symmetries(object), format_class(object));
    row.erase(row.find_last_not_of(' ') + 1);
    table += row;
  }
  return table;
}

std::vector<StageTime> median_times(const std::vector<std::vector<StageTime>>& runs) {
  std::vector<StageTime> medians = runs.front();
  for (std::size_t i = 0; i < medians.size(); ++i) {
    std::vector<double> seconds;
    for (const std::vector<StageTime>& run : runs) seconds.push_back(run.at(i).seconds);
    medians[i].seconds = median(std::move(seconds)).value_or(0.0);
  }
  return medians;
}

}  // namespace symscene::app
