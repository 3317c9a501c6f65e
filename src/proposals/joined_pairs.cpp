#include "joined_pairs.hpp"

#include <algorithm>
#include <iterator>

#include "core/parallel.hpp"
#include "proposals/merge.hpp"
#include "surface_continuation.hpp"

namespace symscene {
namespace {

bool share_points(const PointIndices& a, const PointIndices& b, double max_shared) {
  return static_cast<double>(intersection_size(a, b)) >
         max_shared * static_cast<double>(std::min(a.size(), b.size()));
}

bool lies_in(const PointIndices& part, const PointIndices& whole, double contained_share) {
  return part.size() < whole.size() && static_cast<double>(intersection_size(part, whole)) >
                                           contained_share * static_cast<double>(part.size());
}

}  // namespace

Continuations find_continuations(const PointCloud& cloud, const DistanceField& field,
                                 const std::vector<ObjectProposal>& proposals,
                                 const ContinuationOptions& options) {
  const auto end = std::find_if(proposals.begin(), proposals.end(), [&](const ObjectProposal& p) {
    return p.own_score < options.min_score;
  });
  const auto count = static_cast<std::size_t>(end - proposals.begin());
  const std::size_t best = std::min(count, static_cast<std::size_t>(options.max_proposals));
  std::vector<SurfaceSample> samples(count);
  for (std::size_t k = 0; k < count; ++k) {
    samples[k] = sample_surface(cloud, proposals[k].object.points,
                                static_cast<Index>(options.sample_points));
  }
  Continuations found;
  found.continued.resize(proposals.size(), 0.0);
  std::vector<std::vector<std::size_t>> partners(count);
  parallel_for_each(count, [&](std::size_t a) {
    const PointIndices& own = proposals[a].object.points;
    for (std::size_t b = 0; b < best; ++b) {
      if (a == b) continue;
      const double value = continuation(samples[a], samples[b], field, options);
      if (value <= 0.0 || share_points(own, proposals[b].object.points, options.max_shared))
        continue;
      found.continued[a] = std::max(found.continued[a], value);
      if (a < b && value >= options.min_continuation) partners[a].push_back(b);
    }
  });
  for (std::size_t a = 0; a < count; ++a) {
    for (const std::size_t b : partners[a]) found.pairs.emplace_back(a, b);
  }
  return found;
}

std::vector<SceneObject> joined_pairs(const PointCloud& cloud,
                                      const std::vector<ObjectProposal>& proposals,
                                      const Continuations& continuations, double same_object) {
  std::vector<SceneObject> joined;
  for (const auto& [a, b] : continuations.pairs) {
    const PointIndices &p = proposals[a].object.points, &q = proposals[b].object.points;
    SceneObject object;
    std::set_union(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(object.points));
    const auto repeats = [&](const SceneObject& other) {
      return is_same_set(other.points, object.points, same_object);
    };
    const bool is_known =
        std::any_of(proposals.begin(), proposals.end(),
                    [&](const ObjectProposal& known) { return repeats(known.object); });
    if (is_known || std::any_of(joined.begin(), joined.end(), repeats)) continue;
    object.centroid = centroid(cloud.positions, object.points);
    joined.push_back(std::move(object));
  }
  return joined;
}

void discount_parts(const std::vector<PointIndices>& joined, const ContinuationOptions& options,
                    std::vector<ObjectProposal>& proposals) {
  std::vector<double> probabilities;  // of the joined pairs
  for (const PointIndices& pair : joined) {
    const auto own = std::find_if(proposals.begin(), proposals.end(), [&](const auto& proposal) {
      return proposal.object.points == pair;
    });
    probabilities.push_back(own->probability);
  }
  parallel_for_each(proposals.size(), [&](std::size_t k) {
    double greatest = 0.0;
    for (std::size_t j = 0; j < joined.size(); ++j) {
      if (lies_in(proposals[k].object.points, joined[j], options.contained_share))
        greatest = std::max(greatest, probabilities[j]);
    }
    proposals[k].discount = options.joined_discount * greatest;
  });
}

}  // namespace symscene
