#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "symscene/physics/convex_parts.hpp"
#include "symscene/simulation/object_model.hpp"

namespace symscene {

/// The parts of models by name, so that many scenes of the same models cut each of them once.
class ConvexPartsCache {
 public:
  explicit ConvexPartsCache(const ConvexPartsOptions& options = {}) : options_(options) {}

  /// The parts of each model, in that order. Valid as long as the cache lives.
  std::vector<const ConvexParts*> of(std::span<const ObjectModel> models);

 private:
  ConvexPartsOptions options_;
  std::map<std::string, ConvexParts> parts_;
};

}  // namespace symscene
