#pragma once

#include "symscene/proposals/proposals.hpp"

namespace symscene {

/// A proposal whose relations to the others of its scene are not known yet.
struct ProposalDraft {
  MergedHypothesis merged;
  OwnFeatures features;
  double own_score = 0.0;  ///< from these features
};

}  // namespace symscene
