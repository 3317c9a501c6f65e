#pragma once

#include "evaluation/report_text.hpp"
#include "exploration_measures.hpp"

namespace symscene {

/// A measure by policy (row) and number of views, and its mean over the views, in percent.
TextTable measure_table(const ComparedScenes& scenes, const ExplorationMeasure& measure);

/// Success of the grasp by policy, with its interval; a header alone if none was tried.
TextTable grasp_table(const ComparedScenes& scenes);

/// Areas under the curves of all measures, and success of the grasp: `reference` minus each other
/// policy in points, with the 95 % interval of the paired difference, and relative to the other
/// policy with the interval of that. A header alone without the reference or another policy.
TextTable difference_table(const ComparedScenes& scenes, ExplorationPolicy reference);

/// All measures: `reference` after half of the views minus the fixed arc after all of them, as in
/// difference_table(). A header alone unless both were compared over at least two views.
TextTable half_arc_table(const ComparedScenes& scenes, ExplorationPolicy reference);

/// Median and 95th percentile of the time of a decision by policy. [ms]
TextTable decision_table(const ComparedScenes& scenes);

}  // namespace symscene
