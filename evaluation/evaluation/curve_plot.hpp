#pragma once

#include <string>
#include <vector>

#include "symscene/evaluation/sweep.hpp"

namespace symscene {

/// Precision over recall of methods as an HTML figure: an SVG with a legend below. Faint dots are
/// settings, lines their envelopes, stars the best F, rings the given options; dashed curves join
/// points of equal F. `colors` has the number of the colour of each method.
std::string curve_figure(const std::string& caption, const std::vector<const Sweep*>& sweeps,
                         const std::vector<std::size_t>& colors, Metric metric);

}  // namespace symscene
