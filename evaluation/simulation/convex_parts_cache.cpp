#include "convex_parts_cache.hpp"

#include <utility>

#include "core/parallel.hpp"

namespace symscene {

std::vector<const ConvexParts*> ConvexPartsCache::of(std::span<const ObjectModel> models) {
  std::vector<std::pair<const ObjectModel*, ConvexParts*>> missing;
  for (const ObjectModel& model : models) {
    const auto [place, is_new] = parts_.try_emplace(model.name);
    if (is_new) missing.emplace_back(&model, &place->second);
  }
  parallel_for_each(missing.size(), [&](std::size_t i) {
    *missing[i].second = convex_parts(missing[i].first->mesh, options_);
  });
  std::vector<const ConvexParts*> parts;
  for (const ObjectModel& model : models) parts.push_back(&parts_.at(model.name));
  return parts;
}

}  // namespace symscene
