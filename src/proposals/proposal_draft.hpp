#pragma once

#include "proposals/merge.hpp"
#include "symscene/proposals/object_features.hpp"

namespace symscene {

/// A proposal whose relations to the others of its scene are not known yet.
struct ProposalDraft {
  MergedHypothesis merged;
  ObjectFeatures features;  ///< all but `continued` and `joined`, which are 0
  double own_score = 0.0;   ///< from these features
};

}  // namespace symscene
