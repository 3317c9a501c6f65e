// Fits the models object_alone and object_among_others to samples of symscene_make_object_samples
// (evaluation/training/README.md).
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "fitting.hpp"
#include "io/atomic_file.hpp"
#include "object_samples.hpp"
#include "proposals/independent_set.hpp"
#include "proposals/object_score.hpp"
#include "proposals/proposal_context.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/proposals/object_features.hpp"
#include "symscene/proposals/selection_options.hpp"

namespace symscene::bench {
namespace {

struct Arguments : FitArguments {
  std::vector<std::filesystem::path> held_out;  ///< samples that are scored and not fitted to
  bool leave_out = false;                       ///< score each kind by models of the others
  std::filesystem::path report;                 ///< file for the reliability tables
};

/// The scenes of one file of samples: one kind of input.
struct Kind {
  std::string name;
  std::vector<SceneSamples> scenes;
};

struct ObjectModels {
  TreeModel alone;
  TreeModel among_others;
};

/// A proposal is right if it overlaps an object by more than 0.9, and half right if it is usable.
double target_of(const SceneSamples& scene, std::size_t proposal) {
  float best = 0.0F;
  for (std::size_t k = 0; k < scene.true_sizes.size(); ++k)
    best = std::max(best, scene.overlap(proposal, k));
  return best > 0.9F ? 1.0 : best > 0.75F ? 0.7 : 0.0;
}

/// Every kind has the same weight in sum, and within a kind every scene.
double weight_of(const Kind& kind, const SceneSamples& scene) {
  constexpr double of_kind = 2e4;
  return of_kind /
         static_cast<double>(kind.scenes.size() * std::max<std::size_t>(1, scene.count()));
}

std::vector<Sample> samples_alone(const Kind& kind, const SceneSamples& scene,
                                  const std::vector<std::string>& without) {
  const std::vector<std::string> names = names_of<ObjectFeatures>();
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < scene.count(); ++k) {
    Sample& sample = samples.emplace_back();
    sample.features.assign(scene.features[k].begin(), scene.features[k].end());
    for (std::size_t f = 0; f < names.size(); ++f) {
      if (std::find(without.begin(), without.end(), names[f]) != without.end())
        sample.features[f] = 0.0;
    }
    sample.target = target_of(scene, k);
    sample.weight = weight_of(kind, scene);
  }
  return samples;
}

/// The samples with the relations between the proposals, as the model `alone` estimates them.
std::vector<Sample> samples_among_others(std::vector<Sample> samples, const SceneSamples& scene,
                                         const TreeModel& alone) {
  std::vector<double> estimates;
  for (const Sample& sample : samples) estimates.push_back(alone.probability(sample.features));
  const std::vector<ProposalContext> contexts =
      proposal_contexts(SharedCounts(scene.sizes, scene.shared), estimates);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto values = values_of(contexts[k]);
    samples[k].features.insert(samples[k].features.end(), values.begin(), values.end());
  }
  return samples;
}

void append(std::vector<Sample>& samples, std::vector<Sample> more) {
  std::move(more.begin(), more.end(), std::back_inserter(samples));
}

/// The second model is fitted to out-of-fold estimates of the first, as it will see them on new
/// scenes.
ObjectModels fit(const std::vector<const Kind*>& kinds, const Arguments& arguments) {
  constexpr std::size_t folds = 3;
  std::vector<std::optional<TreeModel>> alone(folds + 1);  // the last one is fitted to all scenes
  parallel_for_each(alone.size(), [&](std::size_t fold) {
    std::vector<Sample> samples;
    for (const Kind* kind : kinds) {
      for (const SceneSamples& scene : kind->scenes) {
        if (scene.number % folds != fold)
          append(samples, samples_alone(*kind, scene, arguments.without));
      }
    }
    alone[fold].emplace(
        fit_model(training_set<ObjectFeatures>("object_alone", arguments, std::move(samples)),
                  arguments.boosting));
  });
  std::vector<Sample> samples;
  for (const Kind* kind : kinds) {
    for (const SceneSamples& scene : kind->scenes)
      append(samples, samples_among_others(samples_alone(*kind, scene, arguments.without), scene,
                                           *alone[scene.number % folds]));
  }
  return {*alone[folds], fit_model(training_set<ObjectFeatures, ProposalContext>(
                                       "object_among_others", arguments, std::move(samples)),
                                   arguments.boosting)};
}

std::vector<double> scores_of(const ObjectModels& models, const Kind& kind,
                              const SceneSamples& scene, const Arguments& arguments) {
  const std::vector<Sample> alone = samples_alone(kind, scene, arguments.without);
  const std::vector<Sample> among_others = samples_among_others(alone, scene, models.alone);
  std::vector<double> scores;
  for (std::size_t k = 0; k < alone.size(); ++k)
    scores.push_back(pooled_probability(models.alone.probability(alone[k].features),
                                        models.among_others.probability(among_others[k].features),
                                        ProposalContextOptions{}.own_weight));
  return scores;
}

/// The proposals that select_probable() selects above `min_score`, without those that it adds where
/// these leave points uncovered.
std::vector<std::size_t> selected(const SceneSamples& scene, const std::vector<double>& scores,
                                  double min_score) {
  const SelectionOptions options;
  ConflictGraph graph;
  std::vector<std::size_t> probable;
  for (std::size_t k = 0; k < scene.count(); ++k) {
    if (scores[k] <= min_score) continue;
    probable.push_back(k);
    graph.weights.push_back(scores[k] - min_score);
  }
  graph.adjacency.resize(probable.size());
  for (std::size_t a = 0; a < probable.size(); ++a) {
    for (std::size_t b = 0; b < probable.size(); ++b) {
      const std::uint32_t shared = scene.shared[(probable[a] * scene.count()) + probable[b]];
      const std::uint32_t smaller = std::min(scene.sizes[probable[a]], scene.sizes[probable[b]]);
      if (a != b && shared > options.max_overlap * smaller) graph.adjacency[a].push_back(b);
    }
  }
  const std::vector<bool> chosen =
      max_weight_independent_set(graph, static_cast<std::size_t>(options.max_exact_conflicts));
  std::vector<std::size_t> objects;
  for (std::size_t a = 0; a < probable.size(); ++a) {
    if (chosen[a]) objects.push_back(probable[a]);
  }
  return objects;
}

/// Precision and recall at two overlaps.
struct Counts {
  DetectionCounts over_90, over_75;

  Counts& operator+=(const Counts& other) {
    over_90 += other.over_90;
    over_75 += other.over_75;
    return *this;
  }
};

Counts count(const SceneSamples& scene, const std::vector<std::size_t>& objects) {
  OverlapMatrix overlaps(scene.true_sizes.size(), objects.size());
  for (std::size_t k = 0; k < scene.true_sizes.size(); ++k) {
    for (std::size_t a = 0; a < objects.size(); ++a)
      overlaps(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(a)) =
          double{scene.overlap(objects[a], k)};
  }
  return {mask_detections(overlaps, 0.9), mask_detections(overlaps, 0.75)};
}

/// How often proposals of one range of scores are right (reliability, Murphy and Winkler 1977).
struct Bin {
  double scores = 0.0, right = 0.0, usable = 0.0;
  std::size_t count = 0;
};
using Reliability = std::array<Bin, 5>;

void add(const SceneSamples& scene, const std::vector<std::size_t>& objects,
         const std::vector<double>& scores, Reliability& bins) {
  for (const std::size_t k : objects) {
    const double scaled = scores[k] * static_cast<double>(bins.size());
    Bin& bin = bins[std::min(bins.size() - 1, static_cast<std::size_t>(scaled))];
    const double target = target_of(scene, k);
    bin.scores += scores[k];
    bin.right += target == 1.0 ? 1.0 : 0.0;
    bin.usable += target > 0.0 ? 1.0 : 0.0;
    ++bin.count;
  }
}

struct Result {
  std::array<Counts, 12> by_threshold;
  Reliability reliability;
};

void add(const Kind& kind, const ObjectModels& models, const Arguments& arguments, Result& result) {
  for (const SceneSamples& scene : kind.scenes) {
    const std::vector<double> scores = scores_of(models, kind, scene, arguments);
    for (std::size_t t = 0; t < result.by_threshold.size(); ++t)
      result.by_threshold[t] +=
          count(scene, selected(scene, scores, 0.05 * static_cast<double>(t + 1)));
    add(scene, selected(scene, scores, 0.05), scores, result.reliability);
  }
}

Result result_of(const Kind& kind, const ObjectModels& models, const Arguments& arguments) {
  Result result;
  add(kind, models, arguments, result);
  return result;
}

void print_row(const std::string& name, const std::vector<std::string>& cells, std::string& text) {
  text += fmt::format("| {} | {} |\n", name, fmt::join(cells, " | "));
}

/// F by threshold and the reliability of each kind, as tables in Markdown.
std::string tables(const std::vector<const Kind*>& kinds, const std::vector<Result>& results) {
  std::string text = "F at IoU > 0.9 and > 0.75 by least score\n\n| kind | objects ";
  const std::size_t thresholds = results.front().by_threshold.size();
  for (std::size_t t = 0; t < thresholds; ++t)
    text += fmt::format("| {:.2f} ", 0.05 * static_cast<double>(t + 1));
  text += "|\n| --- ";
  for (std::size_t t = 0; t <= thresholds; ++t) text += "| --- ";
  text += "|\n";
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    std::vector<std::string> cells{
        fmt::format("{}", results[k].by_threshold.front().over_90.ground_truth)};
    for (const Counts& counts : results[k].by_threshold)
      cells.push_back(
          fmt::format("{:.3f} {:.3f}", counts.over_90.f_measure(), counts.over_75.f_measure()));
    print_row(kinds[k]->name, cells, text);
  }
  text +=
      "\nMean score of selected proposals, and the share of them with IoU > 0.75 (number)\n\n"
      "| kind | 0 to 0.2 | to 0.4 | to 0.6 | to 0.8 | to 1 |\n| --- | --- | --- | --- | --- | --- "
      "|\n";
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    std::vector<std::string> cells;
    for (const Bin& bin : results[k].reliability) {
      const double count = static_cast<double>(std::max<std::size_t>(1, bin.count));
      cells.push_back(
          fmt::format("{:.2f}: {:.2f} ({})", bin.scores / count, bin.usable / count, bin.count));
    }
    print_row(kinds[k]->name, cells, text);
  }
  return text;
}

std::vector<Kind> read_kinds(const std::vector<std::filesystem::path>& files) {
  std::vector<Kind> kinds;
  for (const std::filesystem::path& file : files)
    kinds.push_back({file.stem().string(), read_samples(file)});
  return kinds;
}

/// Each kind scored by models that were fitted to the other kinds.
std::vector<Result> left_out(const std::vector<const Kind*>& kinds, const Arguments& arguments) {
  std::vector<Result> results(kinds.size());
  parallel_for_each(kinds.size(), [&](std::size_t k) {
    std::vector<const Kind*> others = kinds;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    results[k] = result_of(*kinds[k], fit(others, arguments), arguments);
  });
  return results;
}

/// The scenes of a kind whose number is (or is not) that of a fold.
Kind part_of(const Kind& kind, std::size_t folds, std::size_t fold, bool is_fold) {
  Kind part{kind.name, {}};
  std::copy_if(
      kind.scenes.begin(), kind.scenes.end(), std::back_inserter(part.scenes),
      [&](const SceneSamples& scene) { return (scene.number / 3 % folds == fold) == is_fold; });
  return part;
}

/// Each kind scored by models that were fitted to other scenes of all kinds.
std::vector<Result> out_of_fold(const std::vector<const Kind*>& kinds, const Arguments& arguments) {
  constexpr std::size_t folds = 4;
  std::vector<std::vector<Kind>> training(folds);
  std::vector<std::optional<ObjectModels>> models(folds);
  parallel_for_each(folds, [&](std::size_t fold) {
    std::vector<const Kind*> parts;
    for (const Kind* kind : kinds) training[fold].push_back(part_of(*kind, folds, fold, false));
    for (const Kind& kind : training[fold]) parts.push_back(&kind);
    models[fold].emplace(fit(parts, arguments));
  });
  std::vector<Result> results(kinds.size());
  parallel_for_each(kinds.size(), [&](std::size_t k) {
    for (std::size_t fold = 0; fold < folds; ++fold)
      add(part_of(*kinds[k], folds, fold, true), *models[fold], arguments, results[k]);
  });
  return results;
}

std::vector<const Kind*> pointers(const std::vector<Kind>& kinds) {
  std::vector<const Kind*> all;
  for (const Kind& kind : kinds) all.push_back(&kind);
  return all;
}

void run(const Arguments& arguments) {
  const std::vector<Kind> own = read_kinds(arguments.datasets);
  const std::vector<Kind> others = read_kinds(arguments.held_out);
  const std::vector<const Kind*> kinds = pointers(own), held_out = pointers(others);
  std::string report;
  if (arguments.leave_out && kinds.size() > 1)
    report += "Each kind scored by models of the other kinds.\n\n" +
              tables(kinds, left_out(kinds, arguments)) + "\n";
  report += "Each kind scored by models of three quarters of the scenes of all kinds.\n\n" +
            tables(kinds, out_of_fold(kinds, arguments)) + "\n";
  const ObjectModels models = fit(kinds, arguments);
  if (!held_out.empty()) {
    std::vector<Result> results;
    for (const Kind* kind : held_out) results.push_back(result_of(*kind, models, arguments));
    report += "Held-out kinds scored by the models of all others.\n\n" + tables(held_out, results);
  }
  fmt::print("{}", report);
  if (!arguments.report.empty()) write_file_atomically(arguments.report, report);
  for (const TreeModel* model : {&models.alone, &models.among_others}) {
    print_split_counts(*model);
    write_model(arguments, *model);
  }
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{
      "Fits the probability that a proposal is an object to samples of "
      "symscene_make_object_samples, "
      "one "
      "file per kind of input."};
  symscene::bench::add_fit_options(app, arguments);
  app.add_option("--held-out", arguments.held_out, "samples that are scored and not fitted to");
  app.add_flag("--leave-out", arguments.leave_out,
               "score each kind by models of the other kinds too");
  app.add_option("--report", arguments.report,
                 "file for the tables of F and reliability, in Markdown");
  return symscene::bench::run_fit(app, argc, argv, arguments,
                                  [&] { symscene::bench::run(arguments); });
}
