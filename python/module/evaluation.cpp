#include <functional>

#include "bindings.hpp"
#include "running.hpp"

#ifdef SYMSCENE_HAS_EVALUATION
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "option_reading.hpp"
#include "symscene/dataset/dataset_evaluation.hpp"
#include "symscene/evaluation/report.hpp"
#include "symscene/workflow/segment_options.hpp"
#endif

namespace symscene::python {
namespace {

namespace py = pybind11;

#ifndef SYMSCENE_HAS_EVALUATION

std::string evaluate(const py::object&, const std::string&, bool, const py::object&, int) {
  throw InputError("evaluate",
                   "a build with the evaluation's wing (-D SYMSCENE_BUILD_EVALUATION=ON)",
                   "one without");
}

#else

namespace fs = std::filesystem;

/// The JSON of a report, without a date, and warnings, one sentence each.
std::pair<std::string, std::vector<std::string>> evaluate(const fs::path& folder,
                                                          const std::string& options_json,
                                                          bool fast, const py::object& progress,
                                                          int threads) {
  const Running running(progress, threads);
  const auto stages = options_from<SegmentOptions>(options_json);
  EvaluationOptions options;
  options.pipeline = stages.pipeline;
  options.labels = stages.masks;
  options.reflectional_only = !fast;
  SingleViewOptions single_views;
  single_views.view = stages.view;
  return running.without_gil([&] {
    const DatasetListing listing = read_dataset(folder);
    if (listing.entries.empty())
      throw InputError(folder.string(), "at least one scene to evaluate", "none");
    std::vector<std::string> warnings = listing.warnings;
    const EvaluationCalls calls{running.on_begin(),
                                [&](const std::string& warning) { warnings.push_back(warning); }};
    const Evaluation evaluation =
        evaluate_dataset(folder, listing.entries, options, single_views, calls);
    const std::string name = (folder / "").parent_path().filename().string();  // also of "scenes/"
    const ReportInfo info{name, "", SYMSCENE_VERSION, ""};
    return std::pair(report_json(evaluation, info), warnings);
  });
}

#endif

}  // namespace

void bind_evaluation(py::module_& module) {
  module.def("evaluate", &evaluate, py::arg("dataset"), py::arg("options"), py::arg("fast"),
             py::arg("progress"), py::arg("threads"));
}

}  // namespace symscene::python
