#pragma once

#include <string>
#include <vector>

#include "symscene/evaluation/scene_evaluation.hpp"

namespace symscene::app {

/// What --baselines may name in this build: "all, none, ...".
std::string baseline_names();

/// The methods that --baselines asks for: "all" of this build, "none", or names with commas
/// between. Throws InputError if this build has no method of a name.
std::vector<BaselineMethod> baseline_methods(const std::string& names);

}  // namespace symscene::app
