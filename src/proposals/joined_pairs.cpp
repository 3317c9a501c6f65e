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
                                 const std::vector<ProposalDraft>& proposals,
                                 const ContinuationOptions& options) {
  const auto end = std::find_if(proposals.begin(), proposals.end(), [&](const ProposalDraft& p) {
    return p.own_score < options.min_score;
  });
  const auto count = static_cast<std::size_t>(end - proposals.begin());
  const std::size_t best = std::min(count, static_cast<std::size_t>(options.max_proposals));
  std::vector<SurfaceSample> samples(count);
  for (std::size_t k = 0; k < count; ++k) {
    samples[k] = sample_surface(cloud, proposals[k].merged.points,
                                static_cast<Index>(options.sample_points));
  }
  Continuations found;
  found.continued.resize(proposals.size(), 0.0);
  std::vector<std::vector<std::size_t>> partners(count);
  parallel_for_each(count, [&](std::size_t a) {
    const PointIndices& own = proposals[a].merged.points;
    for (std::size_t b = 0; b < best; ++b) {
      if (a == b) continue;
      const double value = continuation(samples[a], samples[b], field, options);
      if (value <= 0.0 || share_points(own, proposals[b].merged.points, options.max_shared))
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

std::vector<MergedHypothesis> joined_pairs(const std::vector<ProposalDraft>& proposals,
                                           const Continuations& continuations, double same_object) {
  std::vector<MergedHypothesis> joined;
  for (const auto& [a, b] : continuations.pairs) {
    const PointIndices &p = proposals[a].merged.points, &q = proposals[b].merged.points;
    MergedHypothesis pair;
    std::set_union(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(pair.points));
    const auto repeats = [&](const MergedHypothesis& other) {
      return cover_same_points(other.points, pair.points, same_object);
    };
    const bool is_known =
        std::any_of(proposals.begin(), proposals.end(),
                    [&](const ProposalDraft& known) { return repeats(known.merged); });
    if (is_known || std::any_of(joined.begin(), joined.end(), repeats)) continue;
    joined.push_back(std::move(pair));
  }
  return joined;
}

std::vector<double> part_discounts(const std::vector<ProposalDraft>& proposals,
                                   const std::vector<double>& probabilities,
                                   const ContinuationOptions& options) {
  std::vector<std::size_t> pairs;
  for (std::size_t k = 0; k < proposals.size(); ++k) {
    if (proposals[k].is_joined_pair) pairs.push_back(k);
  }
  std::vector<double> discounts(proposals.size());
  parallel_for_each(proposals.size(), [&](std::size_t k) {
    double greatest = 0.0;
    for (const std::size_t pair : pairs) {
      if (lies_in(proposals[k].merged.points, proposals[pair].merged.points,
                  options.contained_share))
        greatest = std::max(greatest, probabilities[pair]);
    }
    discounts[k] = options.joined_discount * greatest;
  });
  return discounts;
}

}  // namespace symscene
