#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symscene/evaluation/sweep.hpp"

namespace symscene {

/// The first setting with the greatest F; none without settings.
std::optional<std::size_t> best_setting(const Sweep& sweep, Metric metric);

/// The setting of this number as text: "refl_symmetry=0.3 refl_occlusion=0.005".
std::string setting_text(const Sweep& sweep, std::size_t setting);

/// Every combination of the values of the parameters, the last parameter fastest.
std::vector<std::vector<double>> all_settings(const std::vector<std::vector<double>>& values);

}  // namespace symscene
