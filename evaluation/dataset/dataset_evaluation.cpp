#include "symscene/dataset/dataset_evaluation.hpp"

#include <fmt/format.h>

#include "core/naming.hpp"

namespace symscene {
namespace {

void tell_warnings(const DatasetEntry& entry, std::span<const std::string> warnings,
                   const EvaluationCalls& calls) {
  if (!calls.on_warning) return;
  for (const std::string& warning : warnings) {
    calls.on_warning(fmt::format("scene {}: {}", entry.name, warning));
  }
}

std::optional<LabeledView> view_of(const LoadedEntry& known) {
  if (!known.labeled) return std::nullopt;
  const LabeledFrame& labeled = *known.labeled;
  return LabeledView{labeled.camera, labeled.frame.depth, labeled.labels};
}

/// Objects of an image that have no point are lost for a reason of their own.
void name_reasons(SceneEvaluation& scene, const std::vector<std::string>& lost) {
  for (std::size_t i = 0; i < lost.size(); ++i) {
    if (scene.objects[i].outcome == Outcome::lost && !lost[i].empty())
      scene.objects[i].reason = lost[i];
  }
}

}  // namespace

Evaluation evaluate_dataset(const std::filesystem::path& dataset,
                            std::span<const DatasetEntry> entries, const EvaluationOptions& options,
                            const SingleViewOptions& single_views, const EvaluationCalls& calls) {
  Evaluation evaluation;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const DatasetEntry& entry = entries[k];
    const auto on_begin = [&](const std::string& stage) {
      if (!calls.on_begin) return;
      calls.on_begin(
          fmt::format("scene {} of {}, {}: {}", k + 1, entries.size(), entry.name, stage));
    };
    on_begin("read");
    const LoadedEntry known = load_entry(entry, single_views);
    // Before the scene is evaluated: they explain why that may fail. The evaluation repeats them.
    tell_warnings(entry, known.scene.warnings, calls);
    SceneEvaluation scene = naming(dataset / entry.name, [&] {
      return evaluate_scene(known.scene, known.truth, options, on_begin, view_of(known));
    });
    const std::span<const std::string> all = scene.warnings;
    tell_warnings(entry, all.subspan(known.scene.warnings.size()), calls);
    scene.name = entry.name;
    scene.subset = known.subset;
    name_reasons(scene, known.lost);
    evaluation.add(std::move(scene));
  }
  return evaluation;
}

}  // namespace symscene
