#pragma once

#include <string>
#include <vector>

#include "symscene/evaluation/scene_evaluation.hpp"

namespace symscene::app {

/// The values of --baselines in this build: "all, none, ...".
std::string baseline_names();

/// The baselines of --baselines: "all" of this build, "none", or names separated by commas. Throws
/// InputError if this build does not have one of them.
std::vector<BaselineMethod> baseline_methods(const std::string& names);

}  // namespace symscene::app
