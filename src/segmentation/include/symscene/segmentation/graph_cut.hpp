#pragma once

#include "symscene/core/types.hpp"

namespace symscene {

/// An undirected edge and the cost of giving its nodes different labels.
struct WeightedEdge {
  Index a = 0;
  Index b = 0;
  float weight = 0.0F;
};

}  // namespace symscene
