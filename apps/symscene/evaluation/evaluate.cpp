#include <algorithm>
#include <array>
#include <ctime>
#include <memory>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "evaluation_baselines.hpp"
#include "io/atomic_file.hpp"
#include "session.hpp"
#include "symscene/dataset/dataset_evaluation.hpp"
#include "symscene/evaluation/report.hpp"
#include "symscene/workflow/segment_options.hpp"
#include "workflow/score_models.hpp"

namespace symscene::app {
namespace {

bool belongs_to_report(const std::string& file) {
  static constexpr std::array files = {"report.html", "report.json", "curves.csv",
                                       "objects.csv", "scenes.csv",  "pixels.csv"};
  return std::find(files.begin(), files.end(), file) != files.end();
}

const DirectoryLayout report_layout{"a report folder", "report.json", belongs_to_report};

std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr))); }

void write_report(const std::filesystem::path& folder, const Evaluation& evaluation,
                  const ReportInfo& info, const std::string& json) {
  AtomicDirectory report(folder, report_layout);
  report.write("report.html", report_page(evaluation, info));
  report.write("report.json", json);
  report.write("curves.csv", curves_csv(evaluation));
  report.write("pixels.csv", pixels_csv(evaluation));
  report.write("objects.csv", objects_csv(evaluation));
  report.write("scenes.csv", scenes_csv(evaluation));
  report.commit();
}

/// Stages summed over scenes, in the order of their first mention.
std::vector<StageTime> summed_times(const Evaluation& evaluation) {
  std::vector<StageTime> sums;
  for (const SceneEvaluation& scene : evaluation.scenes) {
    for (const StageTime& time : scene.timings) add_to_sums(sums, time);
  }
  return sums;
}

std::string format_subsets(const Evaluation& evaluation) {
  std::string text;
  for (const auto& [subset, sweeps] : evaluation.subsets)
    text += fmt::format("\nsubset {}\n{}", subset, headline_text(sweeps));
  return text;
}

struct Evaluate {
  SharedOptions shared;
  SegmentOptions stages;
  EvaluationOptions options;
  std::filesystem::path dataset;
  std::filesystem::path earlier;
  std::string baselines = "all";
  bool fast = false;

  OptionFields configure() {
    OptionFields fields = configure_options(stages, shared.config,
                                            [&] { read_score_models(stages.pipeline.models); });
    options.pipeline = stages.pipeline;
    options.labels = stages.masks;
    return fields;
  }

  Evaluation evaluate(const std::vector<DatasetEntry>& entries, Session& session) const {
    SingleViewOptions single_views;
    single_views.view = stages.view;
    const EvaluationCalls calls{session.on_begin(),
                                [&](const std::string& warning) { session.warn(warning); }};
    return evaluate_dataset(dataset, entries, options, single_views, calls);
  }

  std::string made_with(const DatasetListing& listing) const {
    std::string text;
    if (listing.split && listing.seed) {
      text += fmt::format("The {} split, seed {}. ", to_string(*listing.split), *listing.seed);
      if (*listing.split == Split::training)
        text += "Probabilities were fitted to objects of this split. ";
    }
    text += shared.config.empty() ? "Default options"
                                  : fmt::format("Options of {}", shared.config.filename().string());
    return text + fmt::format(", baselines {}{}.", baselines,
                              fast ? ", without the variant by planes alone" : "");
  }

  void print_summary(const Evaluation& evaluation, const std::string& json,
                     const std::string& earlier_json, Session& session) const {
    session.print_line(fmt::format("{}; F in percent\n", what_was_evaluated(evaluation)));
    session.print_line(headline_text(evaluation.segmentation) + "\n" +
                       default_text(evaluation.segmentation) + format_subsets(evaluation));
    const std::string pixels = pixel_text(evaluation.segmentation);
    if (!pixels.empty()) session.print_line(pixels);
    session.print_line(missed_object_text(evaluation));
    session.print_line(runtime_text(evaluation));
    if (!earlier_json.empty())
      session.print_line(report_difference(json, earlier_json, earlier.string()));
    session.print_line((shared.output / "report.html").string());
  }

  /// A sweep with ground truth beside it has to become a scene first.
  void refuse_sequence() const {
    const bool is_sweep = std::filesystem::exists(dataset / "sequence.json") &&
                          std::filesystem::exists(dataset / "truth.json");
    if (!is_sweep) return;
    const std::string name = folder_name(dataset);
    throw InputError(
        dataset.string(),
        fmt::format("a folder of scenes (make one: symscene reconstruct {} -o scenes/{}"
                    ", then symscene evaluate scenes)",
                    dataset.string(), name),
        "a sequence with its ground truth");
  }

  void run() {
    configure();
    require_not_input(shared.output, dataset);
    { const AtomicDirectory can_be_written(absolute(shared.output), report_layout); }
    refuse_sequence();
    const std::string earlier_json = earlier.empty() ? "" : read_file(earlier);
    if (!earlier.empty())
      report_difference(earlier_json, earlier_json, earlier.string());  // before the work
    options.reflectional_only = !fast;
    options.baselines = baseline_methods(baselines);
    Session session("evaluate", shared);
    const DatasetListing listing = read_dataset(dataset);
    session.warn(listing.warnings);
    if (!listing.missing.empty())
      session.warn(
          fmt::format("{}: {} scenes are not made yet", dataset.string(), listing.missing.size()));
    if (listing.entries.empty())
      throw InputError(dataset.string(), "at least one scene to evaluate", "none");
    const Evaluation evaluation = evaluate(listing.entries, session);
    const ReportInfo info{folder_name(dataset), today(), SYMSCENE_VERSION, made_with(listing)};
    const std::string json = report_json(evaluation, info);
    write_report(absolute(shared.output), evaluation, info, json);
    print_summary(evaluation, json, earlier_json, session);
    session.finish(
        {{"output", shared.output},
         {"scenes", evaluation.scenes.size()},
         {"objects", evaluation.outcomes.objects},
         ReportMember::raw("headline", nlohmann::ordered_json::parse(json).at("headline").dump())},
        summed_times(evaluation));
  }
};

}  // namespace

void add_evaluate(CommandLine& line) {
  const auto state = std::make_shared<Evaluate>();
  Arguments arguments(line, "evaluate",
                      "Compare the objects found in scenes with their ground truth",
                      "symscene evaluate dataset -o report");
  arguments.input(state->dataset, "DATASET",
                  "dataset folder, or any folder of scene folders with ground truth");
  arguments.output_folder(state->shared, "report folder to write");
  arguments.file("--compare", state->earlier,
                 "report.json of an earlier run: print the differences");
  arguments.text("--baselines", "NAMES", state->baselines,
                 fmt::format("baselines to compare with, separated by commas: {} (default: {})",
                             baseline_names(), state->baselines));
  arguments.flag("--fast", state->fast, "leave out the variants without the rotational stream");
  arguments.run_stages(state);
}

}  // namespace symscene::app
