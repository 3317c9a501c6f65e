#include "symscene/evaluation/evaluation.hpp"

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

void add_sweeps(const std::vector<Sweep>& from, std::vector<Sweep>& to) {
  if (to.empty()) to.resize(from.size());
  if (to.size() != from.size()) {
    throw InputError("scene", std::to_string(to.size()) + " methods as in the scenes before",
                     std::to_string(from.size()));
  }
  for (std::size_t k = 0; k < from.size(); ++k) to[k] += from[k];
}

void add_time(const StageTime& time, RuntimeClass& to) {
  const bool rotational =
      time.stage.starts_with("rotational") || time.stage == "removal of rotational objects";
  const bool reflectional = time.stage.starts_with("reflectional");
  (rotational ? to.rotational : reflectional ? to.reflectional : to.other) += time.seconds;
}

/// Labels of images have no names but numbers: "object 12" is of the kind "object".
std::string kind_of(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  if (last == std::string::npos || last + 1 == name.size() || name[last] != ' ') return name;
  return name.substr(0, last);
}

}  // namespace

void OutcomeCounts::add(const ObjectOutcome& outcome) {
  const auto k = static_cast<std::size_t>(outcome.outcome);
  ++objects;
  ++counts[k];
  if (!outcome.reason.empty()) ++reasons[k][outcome.reason];
  over_75 += outcome.best_overlap > 0.75 ? 1 : 0;
  overlap_sum += outcome.best_overlap;
  symmetries += outcome.symmetries;
  symmetries_met += outcome.symmetries_met;
}

OutcomeCounts& OutcomeCounts::operator+=(const OutcomeCounts& other) {
  objects += other.objects;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    counts[k] += other.counts[k];
    for (const auto& [reason, count] : other.reasons[k]) reasons[k][reason] += count;
  }
  over_75 += other.over_75;
  overlap_sum += other.overlap_sum;
  symmetries += other.symmetries;
  symmetries_met += other.symmetries_met;
  return *this;
}

void Evaluation::add(SceneEvaluation scene) {
  add_sweeps(scene.segmentation, segmentation);
  add_sweeps(scene.detection, detection);
  if (!scene.subset.empty()) add_sweeps(scene.segmentation, subsets[scene.subset]);
  for (const ObjectOutcome& outcome : scene.objects) {
    outcomes.add(outcome);
    if (outcome.is_small) small_objects.add(outcome);
    kinds[kind_of(outcome.kind)].add(outcome);
  }
  scenes.push_back(std::move(scene));
}

std::vector<RuntimeClass> runtimes(const Evaluation& evaluation) {
  std::vector<RuntimeClass> classes(3);
  classes[0].name = "4 or fewer objects";
  classes[1].name = "5 to 10 objects";
  classes[2].name = "more than 10 objects";
  for (const SceneEvaluation& scene : evaluation.scenes) {
    const std::size_t objects = scene.objects.size();
    RuntimeClass& its = classes[objects <= 4 ? 0 : objects <= 10 ? 1 : 2];
    ++its.scenes;
    for (const StageTime& time : scene.timings) add_time(time, its);
  }
  for (RuntimeClass& its : classes) {
    if (its.scenes == 0) continue;
    const auto count = static_cast<double>(its.scenes);
    its.rotational /= count;
    its.reflectional /= count;
    its.other /= count;
  }
  return classes;
}

}  // namespace symscene
