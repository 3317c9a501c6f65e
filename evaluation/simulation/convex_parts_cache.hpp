#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "symscene/physics/convex_parts.hpp"
#include "symscene/simulation/object_model.hpp"

namespace symscene {

/// The convex parts of models by name, so that a model that occurs twice is decomposed once.
class ConvexPartsCache {
 public:
  explicit ConvexPartsCache(const ConvexPartsOptions& options = {}) : options_(options) {}

  /// The parts of each model, in the order of the models. Valid during the lifetime of the cache.
  std::vector<const ConvexParts*> of(std::span<const ObjectModel> models);

 private:
  ConvexPartsOptions options_;
  std::map<std::string, ConvexParts> parts_;
};

}  // namespace symscene
