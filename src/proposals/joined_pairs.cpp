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
  std::vector<std::vector<JoinedPair>> partners(count);
  parallel_for_each(count, [&](std::size_t a) {
    const PointIndices& own = proposals[a].merged.points;
    for (std::size_t b = 0; b < best; ++b) {
      if (a == b) continue;
      const double value = continuation(samples[a], samples[b], field, options);
      if (value <= 0.0 || share_points(own, proposals[b].merged.points, options.max_shared))
        continue;
      found.continued[a] = std::max(found.continued[a], value);
      if (a < b && value >= options.min_continuation) partners[a].push_back({a, b, value});
    }
  });
  for (std::size_t a = 0; a < count; ++a) {
    found.pairs.insert(found.pairs.end(), partners[a].begin(), partners[a].end());
  }
  return found;
}

std::vector<MergedHypothesis> joined_pairs(const std::vector<ProposalDraft>& proposals,
                                           const Continuations& continuations, double same_object) {
  std::vector<MergedHypothesis> joined;
  for (const auto& [a, b, continuation] : continuations.pairs) {
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

std::vector<double> joined_values(const std::vector<ProposalDraft>& proposals,
                                  const Continuations& continuations, double same_object) {
  std::vector<double> joined(proposals.size(), 0.0);
  parallel_for_each(proposals.size(), [&](std::size_t k) {
    const PointIndices& whole = proposals[k].merged.points;
    for (const JoinedPair& pair : continuations.pairs) {
      const PointIndices &p = proposals[pair.a].merged.points, &q = proposals[pair.b].merged.points;
      // The two share few points, so that other sizes cannot be nearly the same.
      const std::size_t size = p.size() + q.size();
      if (pair.continuation <= joined[k] || 9 * whole.size() > 10 * size ||
          9 * size > 10 * whole.size())
        continue;
      PointIndices both;
      std::set_union(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(both));
      if (cover_same_points(whole, both, same_object)) joined[k] = pair.continuation;
    }
  });
  return joined;
}

}  // namespace symscene
