#include "proposals/selection.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/median.hpp"
#include "independent_set.hpp"

namespace symscene {
namespace {

/// The share of the smaller one's points that both have.
double overlap(const SceneObject& a, const SceneObject& b) {
  const std::size_t smaller = std::min(a.points.size(), b.points.size());
  return smaller == 0 ? 0.0
                      : static_cast<double>(intersection_size(a.points, b.points)) /
                            static_cast<double>(smaller);
}

ConflictGraph conflict_graph(const std::vector<SceneObject>& objects, std::vector<double> weights,
                             double max_overlap) {
  ConflictGraph graph;
  graph.weights = std::move(weights);
  graph.adjacency.resize(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(objects[i], objects[j]) <= max_overlap) continue;
      graph.adjacency[i].push_back(j);
      graph.adjacency[j].push_back(i);
    }
  }
  for (std::vector<std::size_t>& nodes : graph.adjacency) std::sort(nodes.begin(), nodes.end());
  return graph;
}

bool is_part(const SceneObject& part, const SceneObject& whole, const SelectionOptions& options) {
  const auto size = static_cast<double>(part.points.size());
  const auto common = static_cast<double>(intersection_size(part.points, whole.points));
  return common > options.part_contained_share * size &&
         size < options.max_part_share * static_cast<double>(whole.points.size());
}

/// The share of an object's points in its consistent parts: by falling score, those that do not
/// conflict with a better one.
double share_in_parts(const std::vector<SceneObject>& objects, std::size_t whole,
                      const SelectionOptions& options) {
  std::vector<std::size_t> parts;
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
  const PointIndices& points = objects[whole].points;
  return static_cast<double>(intersection_size(covered, points)) /
         static_cast<double>(points.size());
}

Rejection rejection_of(const SceneObject& object, const char* reason, double value, double bound) {
  const char* kind = !object.rotational.empty()     ? "rotational"
                     : !object.reflectional.empty() ? "reflectional"
                                                    : "surface";
  return {kind, reason, value, bound, object.points.size(), object.points};
}

std::vector<SceneObject> without_composites(std::vector<SceneObject> objects,
                                            const SelectionOptions& options,
                                            std::vector<Rejection>& rejected) {
  std::vector<double> shares(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) shares[i] = share_in_parts(objects, i, options);
  std::vector<SceneObject> kept;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (shares[i] > options.min_parts_cover) {
      rejected.push_back(rejection_of(objects[i], "composite", shares[i], options.min_parts_cover));
    } else {
      kept.push_back(std::move(objects[i]));
    }
  }
  return kept;
}

double greatest_overlap(const std::vector<SceneObject>& objects, std::size_t object,
                        const std::vector<bool>& chosen) {
  double greatest = 0.0;
  for (std::size_t j = 0; j < objects.size(); ++j) {
    if (chosen[j]) greatest = std::max(greatest, overlap(objects[object], objects[j]));
  }
  return greatest;
}

/// A maximum-weight independent set of the objects' conflict graph; the others are rejected.
std::vector<SceneObject> independent_objects(std::vector<SceneObject> objects,
                                             std::vector<double> weights,
                                             const SelectionOptions& options,
                                             std::vector<Rejection>& rejected) {
  const std::vector<bool> chosen =
      max_weight_independent_set(conflict_graph(objects, std::move(weights), options.max_overlap),
                                 static_cast<std::size_t>(options.max_exact_conflicts));
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (chosen[i]) continue;
    rejected.push_back(rejection_of(objects[i], "overlap", greatest_overlap(objects, i, chosen),
                                    options.max_overlap));
  }
  std::vector<SceneObject> selected;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (chosen[i]) selected.push_back(std::move(objects[i]));
  }
  return selected;
}

bool overlaps_any(const SceneObject& object, const std::vector<SceneObject>& others,
                  double max_overlap) {
  return std::any_of(others.begin(), others.end(), [&](const SceneObject& other) {
    return overlap(object, other) > max_overlap;
  });
}

/// The median number of points; 0 for no objects.
double median_size(const std::vector<SceneObject>& objects) {
  std::vector<std::size_t> sizes;
  for (const SceneObject& object : objects) sizes.push_back(object.points.size());
  return static_cast<double>(median(std::move(sizes)).value_or(0));
}

/// The independent objects whose scores exceed `min_score` by the greatest sum; those that do not
/// exceed it are appended to `unlikely`.
std::vector<SceneObject> best_above(double min_score, std::vector<SceneObject> objects,
                                    const SelectionOptions& options,
                                    std::vector<SceneObject>& unlikely,
                                    std::vector<Rejection>& rejected) {
  std::vector<SceneObject> likely;
  std::vector<double> weights;
  for (SceneObject& object : objects) {
    if (object.score <= min_score) {
      unlikely.push_back(std::move(object));
      continue;
    }
    weights.push_back(object.score - min_score);
    likely.push_back(std::move(object));
  }
  return independent_objects(std::move(likely), std::move(weights), options, rejected);
}

}  // namespace

std::vector<SceneObject> select_consistent(std::vector<SceneObject> objects,
                                           const SelectionOptions& options,
                                           std::vector<Rejection>& rejected) {
  objects = without_composites(std::move(objects), options, rejected);
  std::vector<double> weights;
  for (const SceneObject& object : objects) {
    weights.push_back(static_cast<double>(object.points.size()) *
                      std::pow(object.score, options.score_exponent));
  }
  return independent_objects(std::move(objects), std::move(weights), options, rejected);
}

std::vector<SceneObject> select_probable(std::vector<SceneObject> objects,
                                         const SelectionOptions& options,
                                         std::vector<Rejection>& rejected) {
  std::vector<SceneObject> unlikely, discarded;
  std::vector<SceneObject> selected =
      best_above(options.min_score, std::move(objects), options, unlikely, rejected);
  const double min_score = options.uncovered_ratio * options.min_score;
  const double min_size = options.uncovered_size * median_size(selected);
  std::vector<SceneObject> uncovered;
  for (SceneObject& object : unlikely) {
    const bool is_candidate = object.score > min_score &&
                              static_cast<double>(object.points.size()) >= min_size &&
                              !overlaps_any(object, selected, options.max_overlap);
    if (is_candidate) {
      uncovered.push_back(std::move(object));
    } else {
      rejected.push_back(rejection_of(object, "score", object.score, options.min_score));
    }
  }
  std::vector<SceneObject> more =
      best_above(min_score, std::move(uncovered), options, discarded, rejected);
  std::move(more.begin(), more.end(), std::back_inserter(selected));
  return selected;
}

}  // namespace symscene
