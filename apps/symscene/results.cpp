#include "results.hpp"

#include <algorithm>

#include <fmt/format.h>

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

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace

std::string format_objects(const SegmentationResult& result) {
  const bool scored = result.objects.empty() || result.objects.front().score;
  std::string table = fmt::format("{:>3}  {:>6}  {:>5}  {}", "id", "points",
                                  scored ? "score" : "confidence", "symmetries");
  for (std::size_t id = 0; id < result.objects.size(); ++id) {
    const SceneObject& object = result.objects[id];
    table += fmt::format("\n{:>3}  {:>6}  {:>5.2f}  {}", id, object.points.size(), object.rank(),
                         format_symmetries(object));
  }
  return table;
}

std::vector<StageTime> median_times(const std::vector<std::vector<StageTime>>& runs) {
  std::vector<StageTime> medians = runs.front();
  for (std::size_t i = 0; i < medians.size(); ++i) {
    std::vector<double> seconds;
    for (const std::vector<StageTime>& run : runs) seconds.push_back(run.at(i).seconds);
    medians[i].seconds = median(std::move(seconds));
  }
  return medians;
}

}  // namespace symscene::app
