#pragma once

#include "proposals/merge.hpp"
#include "symscene/proposals/object_features.hpp"

namespace symscene {

/// A proposal whose relations to the others of its scene are not known yet.
struct ProposalDraft {
  MergedHypothesis merged;
  ObjectFeatures features;      ///< all but `continued`, which is 0
  double own_score = 0.0;       ///< from these features, combined with the confidence
  bool is_joined_pair = false;  ///< the union of two others that continue each other
};

}  // namespace symscene
