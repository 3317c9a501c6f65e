#include "proposals/selection.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/median.hpp"
#include "proposals/independent_set.hpp"

namespace symscene {
namespace {

using Candidates = std::vector<SelectionCandidate>;
using Indices = std::vector<std::size_t>;

/// The share of the smaller one's points that both have.
double overlap(const SelectionCandidate& a, const SelectionCandidate& b) {
  const std::size_t smaller = std::min(a.points.size(), b.points.size());
  return smaller == 0 ? 0.0
                      : static_cast<double>(intersection_size(a.points, b.points)) /
                            static_cast<double>(smaller);
}

ConflictGraph conflict_graph(const Candidates& objects, const Indices& nodes,
                             std::vector<double> weights, double max_overlap) {
  ConflictGraph graph;
  graph.weights = std::move(weights);
  graph.adjacency.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(objects[nodes[i]], objects[nodes[j]]) <= max_overlap) continue;
      graph.adjacency[i].push_back(j);
      graph.adjacency[j].push_back(i);
    }
  }
  for (Indices& adjacent : graph.adjacency) std::sort(adjacent.begin(), adjacent.end());
  return graph;
}

bool is_part(const SelectionCandidate& part, const SelectionCandidate& whole,
             const SelectionOptions& options) {
  const auto size = static_cast<double>(part.points.size());
  const auto common = static_cast<double>(intersection_size(part.points, whole.points));
  return common > options.part_contained_share * size &&
         size < options.max_part_share * static_cast<double>(whole.points.size());
}

/// The share of an object's points in its consistent parts: by falling score, those that do not
/// conflict with a better one.
double share_in_parts(const Candidates& objects, std::size_t whole,
                      const SelectionOptions& options) {
  Indices parts;
  PointIndices covered;
  for (std::size_t i = 0; i < objects.size(); ++i) {  // objects come by falling score
    const bool conflicts = std::any_of(parts.begin(), parts.end(), [&](std::size_t part) {
      return overlap(objects[i], objects[part]) > options.max_overlap;
    });
    if (i == whole || conflicts || !is_part(objects[i], objects[whole], options)) continue;
    parts.push_back(i);
    PointIndices joined;
    std::set_union(covered.begin(), covered.end(), objects[i].points.begin(),
                   objects[i].points.end(), std::back_inserter(joined));
    covered = std::move(joined);
  }
  const std::span<const Index> points = objects[whole].points;
  return static_cast<double>(intersection_size(covered, points)) /
         static_cast<double>(points.size());
}

Rejection rejection_of(const SelectionCandidate& object, const char* reason, double value,
                       double bound) {
  return {object.kind,
          reason,
          value,
          bound,
          object.points.size(),
          {object.points.begin(), object.points.end()}};
}

Indices without_composites(const Candidates& objects, const SelectionOptions& options,
                           std::vector<Rejection>& rejected) {
  Indices kept;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const double share = share_in_parts(objects, i, options);
    if (share > options.min_parts_cover) {
      rejected.push_back(rejection_of(objects[i], "composite", share, options.min_parts_cover));
    } else {
      kept.push_back(i);
    }
  }
  return kept;
}

double greatest_overlap(const Candidates& objects, std::size_t object, const Indices& others) {
  double greatest = 0.0;
  for (const std::size_t other : others)
    greatest = std::max(greatest, overlap(objects[object], objects[other]));
  return greatest;
}

/// A maximum-weight independent set of the conflict graph of `among`; the others are rejected.
Indices independent_objects(const Candidates& objects, const Indices& among,
                            std::vector<double> weights, const SelectionOptions& options,
                            std::vector<Rejection>& rejected) {
  const std::vector<bool> is_selected = max_weight_independent_set(
      conflict_graph(objects, among, std::move(weights), options.max_overlap),
      static_cast<std::size_t>(options.max_exact_conflicts));
  Indices selected, others;
  for (std::size_t k = 0; k < among.size(); ++k)
    (is_selected[k] ? selected : others).push_back(among[k]);
  for (const std::size_t other : others) {
    rejected.push_back(rejection_of(objects[other], "overlap",
                                    greatest_overlap(objects, other, selected),
                                    options.max_overlap));
  }
  return selected;
}

/// The median number of points; 0 for no objects.
double median_size(const Candidates& objects, const Indices& among) {
  std::vector<std::size_t> sizes;
  for (const std::size_t i : among) sizes.push_back(objects[i].points.size());
  return static_cast<double>(median(std::move(sizes)).value_or(0));
}

/// Which objects a round selects, and what it maximises.
struct Round {
  double min_score;  ///< only objects with a higher score
  double cost;       ///< the sum of the scores minus the cost of each object is maximised
};

/// The best independent objects of `among`; those that do not exceed `min_score` are appended to
/// `unlikely`.
Indices best_of(const Round& round, const Candidates& objects, const Indices& among,
                const SelectionOptions& options, Indices& unlikely,
                std::vector<Rejection>& rejected) {
  Indices likely;
  std::vector<double> weights;
  for (const std::size_t i : among) {
    if (objects[i].score <= round.min_score) {
      unlikely.push_back(i);
      continue;
    }
    weights.push_back(objects[i].score - round.cost);
    likely.push_back(i);
  }
  return independent_objects(objects, likely, std::move(weights), options, rejected);
}

Indices all_of(const Candidates& objects) {
  Indices all(objects.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

SelectionCandidate selection_candidate(const MergedHypothesis& merged, double score) {
  const char* kind = !merged.axes.empty()     ? "rotational"
                     : !merged.planes.empty() ? "reflectional"
                                              : "surface";
  return {merged.points, score, kind};
}

std::vector<std::size_t> select_consistent(const std::vector<SelectionCandidate>& objects,
                                           const SelectionOptions& options,
                                           std::vector<Rejection>& rejected) {
  const Indices kept = without_composites(objects, options, rejected);
  std::vector<double> weights;
  for (const std::size_t i : kept) {
    weights.push_back(static_cast<double>(objects[i].points.size()) *
                      std::pow(objects[i].score, options.confidence_exponent));
  }
  return independent_objects(objects, kept, std::move(weights), options, rejected);
}

std::vector<std::size_t> select_probable(const std::vector<SelectionCandidate>& objects,
                                         const SelectionOptions& options,
                                         std::vector<Rejection>& rejected) {
  Indices unlikely, discarded;
  Indices selected = best_of({.min_score = options.min_score, .cost = options.min_score}, objects,
                             all_of(objects), options, unlikely, rejected);
  const double min_score = options.uncovered_ratio * options.min_score;
  const double min_size = options.uncovered_size * median_size(objects, selected);
  Indices uncovered;
  for (const std::size_t i : unlikely) {
    const SelectionCandidate& object = objects[i];
    const bool is_candidate = object.score > min_score &&
                              static_cast<double>(object.points.size()) >= min_size &&
                              greatest_overlap(objects, i, selected) <= options.max_overlap;
    if (is_candidate) {
      uncovered.push_back(i);
    } else {
      rejected.push_back(rejection_of(object, "score", object.score, options.min_score));
    }
  }
  // A cost per object favours an uncertain union over its uncertain parts.
  const Indices more = best_of({.min_score = min_score, .cost = 0.0}, objects, uncovered, options,
                               discarded, rejected);
  selected.insert(selected.end(), more.begin(), more.end());
  return selected;
}

}  // namespace symscene
