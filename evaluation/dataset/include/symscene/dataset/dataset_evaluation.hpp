#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "symscene/dataset/dataset_folder.hpp"
#include "symscene/evaluation/evaluation.hpp"

namespace symscene {

/// What is called while a dataset is evaluated. Each may be empty.
struct EvaluationCalls {
  StageTimer::OnBegin on_begin;                                ///< "scene 2 of 9, NAME: STAGE"
  std::function<void(const std::string& warning)> on_warning;  ///< "scene NAME: ..."
};

/// Evaluates scenes of a dataset one after the other. `dataset` is its folder, for messages.
/// Throws InputError as load_entry() and evaluate_scene() do.
Evaluation evaluate_dataset(const std::filesystem::path& dataset,
                            std::span<const DatasetEntry> entries, const EvaluationOptions& options,
                            const SingleViewOptions& single_views,
                            const EvaluationCalls& calls = {});

}  // namespace symscene
