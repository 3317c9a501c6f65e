#pragma once

#include <string>
#include <vector>

#include "symscene/evaluation/sweep.hpp"

namespace symscene {

/// Precision over recall of some methods, as a figure of HTML: an SVG and a legend under it. Faint
/// dots are settings, lines their envelopes, stars the best F, rings the given options; thin curves
/// join points of equal F. `colors` are the numbers of the methods' colours.
std::string curve_figure(const std::string& caption, const std::vector<const Sweep*>& sweeps,
                         const std::vector<std::size_t>& colors, Metric metric);

}  // namespace symscene
