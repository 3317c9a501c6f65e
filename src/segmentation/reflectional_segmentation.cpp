#include "symscene/segmentation/reflectional_segmentation.hpp"

#include <algorithm>
#include <numeric>
#include <variant>

#include "core/disjoint_sets.hpp"
#include "core/parallel.hpp"
#include "graph_cut.hpp"
#include "labeling.hpp"
#include "neighborhood.hpp"
#include "symmetry/plane_fit.hpp"
#include "symmetry/point_residuals.hpp"
#include "symmetry/score_range.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr float cell_size = 0.01F;  ///< of the search for neighbours; changes no result [m]

constexpr Index outside = ~Index{0};

/// The part of a cloud that is connected with the segment that proposes a plane, by edges of the
/// surface graph and pairs of symmetric points. A cut labels each such part by itself, and drops
/// those without a point of the segment.
struct ConnectedPart {
  PointIndices points;              ///< into the cloud, ascending
  std::vector<Index> place;         ///< one per point of the cloud, into `points`, or outside
  std::vector<WeightedEdge> edges;  ///< between places, with one for each pair
};

/// A labelling with the matches under the plane that it was cut out with.
struct PlaneLabelling {
  std::vector<std::uint8_t> is_object;
  std::vector<Correspondence> matches;
};

class ReflectionalCutter {
 public:
  ReflectionalCutter(const ObservedSurface& surface, const PlaneFitOptions& fit,
                     const ReflectionalSegmentationOptions& options)
      : cloud_(surface.cloud),
        scaled_edges_(surface.edges),
        cells_(surface.cloud.positions, cell_size),
        component_(connected_components(std::vector<std::uint8_t>(surface.cloud.size(), 1),
                                        surface.edges)),
        all_points_(surface.cloud.size()),
        field_(surface.field),
        fit_(fit),
        options_(options) {
    for (WeightedEdge& edge : scaled_edges_) edge.weight *= static_cast<float>(options.edge_factor);
    for (const Index component : component_)
      components_ = std::max(components_, std::size_t{component} + 1);
    edges_of_.resize(components_);
    for (const WeightedEdge& edge : scaled_edges_) edges_of_[component_[edge.a]].push_back(edge);
    std::iota(all_points_.begin(), all_points_.end(), Index{0});
  }

  /// The points that are consistent with the candidate's plane, refitted; or the rejection if they
  /// lose the segment that proposed it.
  std::variant<Hypothesis, Rejection> segment(const ReflectionalCandidate& candidate) const {
    ReflectionMatcher matcher({cloud_, cells_}, all_points_, options_.matching);
    const PlaneLabelling first = cut(candidate.plane, candidate.support, matcher);
    if (!holds_support(first, candidate.support))
      return support_rejection(first, candidate.support);
    const ReflectionPlane plane = refitted(candidate.plane, first.is_object);
    const PlaneLabelling second = cut(plane, candidate.support, matcher);
    if (!holds_support(second, candidate.support))
      return support_rejection(second, candidate.support);
    Hypothesis hypothesis;
    hypothesis.points = object_nodes(second.is_object);
    hypothesis.residuals = residuals(second, plane, hypothesis.points);
    hypothesis.plane = plane;
    return hypothesis;
  }

 private:
  float occlusion(const PlaneReflector& reflector, Index i) const {
    return occlusion_range(options_)(field_.at(reflector.point(cloud_.position(i))));
  }

  /// Eqs. 4.4 to 4.9. A point whose normal lies in the plane looks symmetric under any parallel
  /// plane: outside the proposing segment it is weak evidence.
  std::vector<Affinity> affinities(const ReflectionPlane& plane, const PointIndices& support,
                                   const ConnectedPart& part,
                                   const std::vector<Correspondence>& matches) const {
    const PlaneReflector reflector(plane);
    std::vector<Affinity> affinities(part.points.size());
    for (std::size_t k = 0; k < part.points.size(); ++k) {
      affinities[k].background =
          static_cast<float>(options_.background_weight) * occlusion(reflector, part.points[k]);
    }
    for (const Correspondence& match : matches) {
      if (part.place[match.from] == outside) continue;
      const float facing = safe_acos(std::abs(cloud_.normal(match.from).dot(reflector.normal())));
      const float weak =
          std::binary_search(support.begin(), support.end(), match.from)
              ? 0.0F
              : ScoreRange{options_.full_weight_angle, options_.zero_weight_angle}(facing);
      affinities[part.place[match.from]].object =
          (1.0F - angle_range(options_)(safe_acos(match.cosine))) * (1.0F - weak);
    }
    return affinities;
  }

  /// The points of the components of the surface graph that pairs join with one of the segment.
  PointIndices points_joined_with(const PointIndices& support,
                                  const std::vector<Correspondence>& matches) const {
    DisjointSets joined(components_);
    for (const Correspondence& match : matches)
      joined.join(component_[match.from], component_[match.to]);
    std::vector<std::uint8_t> holds_support(components_, 0);
    for (const Index i : support) holds_support[joined.leader(component_[i])] = 1;
    PointIndices points;
    for (Index i = 0; i < cloud_.size(); ++i) {
      if (holds_support[joined.leader(component_[i])] != 0) points.push_back(i);
    }
    return points;
  }

  /// With an edge between every two symmetric points, which joins the halves of an object.
  ConnectedPart connected_part(const PointIndices& support,
                               const std::vector<Correspondence>& matches) const {
    ConnectedPart part{points_joined_with(support, matches), {}, {}};
    part.place.assign(cloud_.size(), outside);
    std::vector<std::uint8_t> has_component(components_, 0);
    for (Index k = 0; k < part.points.size(); ++k) {
      part.place[part.points[k]] = k;
      has_component[component_[part.points[k]]] = 1;
    }
    for (std::size_t component = 0; component < components_; ++component) {
      if (has_component[component] == 0) continue;
      for (const WeightedEdge& edge : edges_of_[component])
        part.edges.push_back({part.place[edge.a], part.place[edge.b], edge.weight});
    }
    append_pairs(matches, part);
    return part;
  }

  void append_pairs(const std::vector<Correspondence>& matches, ConnectedPart& part) const {
    std::vector<std::pair<Index, Index>> pairs;
    for (const Correspondence& match : matches) {
      if (part.place[match.from] != outside)
        pairs.emplace_back(std::minmax(part.place[match.from], part.place[match.to]));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    const auto weight = static_cast<float>(options_.pair_weight * options_.edge_factor);
    for (const auto& [a, b] : pairs) part.edges.push_back({a, b, weight});
  }

  PlaneLabelling cut(const ReflectionPlane& plane, const PointIndices& support,
                     ReflectionMatcher& matcher) const {
    PlaneLabelling result;
    result.matches = matcher.match(plane);
    const ConnectedPart part = connected_part(support, result.matches);
    std::vector<std::uint8_t> is_object =
        cut_graph(affinities(plane, support, part, result.matches), part.edges).is_object;
    keep_components_of(support, part, is_object);
    result.is_object.assign(cloud_.size(), 0);
    for (std::size_t k = 0; k < part.points.size(); ++k)
      result.is_object[part.points[k]] = is_object[k];
    return result;
  }

  /// Drops the components without a point of the proposing segment: they belong to other objects.
  static void keep_components_of(const PointIndices& support, const ConnectedPart& part,
                                 std::vector<std::uint8_t>& is_object) {
    const std::vector<Index> component = connected_components(is_object, part.edges);
    std::vector<std::uint8_t> supported(component.size() + 1, 0);
    for (const Index i : support) {
      const Index own = component[part.place[i]];
      if (own != no_component) supported[own] = 1;
    }
    for (std::size_t k = 0; k < is_object.size(); ++k) {
      if (is_object[k] != 0 && supported[component[k]] == 0) is_object[k] = 0;
    }
  }

  static double held_share(const PlaneLabelling& labelling, const PointIndices& support) {
    std::size_t held = 0;
    for (const Index i : support) held += labelling.is_object[i];
    return static_cast<double>(held) / static_cast<double>(support.size());
  }

  bool holds_support(const PlaneLabelling& labelling, const PointIndices& support) const {
    return held_share(labelling, support) >= options_.min_support_share &&
           !object_nodes(labelling.is_object).empty();
  }

  Rejection support_rejection(const PlaneLabelling& labelling, const PointIndices& support) const {
    PointIndices points = object_nodes(labelling.is_object);
    const std::size_t size = points.size();
    return {"reflectional",
            "support",
            held_share(labelling, support),
            options_.min_support_share,
            size,
            std::move(points)};
  }

  ReflectionPlane refitted(const ReflectionPlane& plane,
                           const std::vector<std::uint8_t>& is_object) const {
    const PointIndices members = object_nodes(is_object);
    const PointCloud part = select(cloud_, members);
    const CellList cells(part.positions, cell_size);
    PointIndices sources(members.size());
    std::iota(sources.begin(), sources.end(), Index{0});
    const PlaneFit fit = fit_plane({part, cells}, sources, plane, fit_);
    return is_usable(fit.status) ? fit.plane : plane;
  }

  /// Eqs. 4.11 to 4.13.
  HypothesisResiduals residuals(const PlaneLabelling& labelling, const ReflectionPlane& plane,
                                const PointIndices& points) const {
    double symmetry = 0.0;
    double matched = 0.0;
    for (const Correspondence& match : labelling.matches) {
      if (labelling.is_object[match.from] == 0) continue;
      symmetry += double{angle_range(options_)(safe_acos(match.cosine))};
      matched += 1.0;
    }
    const PlaneReflector reflector(plane);
    double occluded = 0.0;
    for (const Index i : points) occluded += double{occlusion(reflector, i)};
    return {matched > 0.0 ? symmetry / matched : 1.0, occluded / static_cast<double>(points.size()),
            smoothness(labelling.is_object, scaled_edges_)};
  }

  const PointCloud& cloud_;
  std::vector<WeightedEdge> scaled_edges_;
  CellList cells_;
  std::vector<Index> component_;  ///< of the surface graph, one per point
  std::size_t components_ = 0;
  std::vector<std::vector<WeightedEdge>> edges_of_;  ///< scaled, one list per component
  PointIndices all_points_;
  const DistanceField& field_;
  const PlaneFitOptions& fit_;
  const ReflectionalSegmentationOptions& options_;
};

using Outcome = std::variant<Hypothesis, Rejection>;

/// What a candidate cuts out of the part of the surface around its segment; indices into the whole.
Outcome segment_part(const SurfacePart& part, ReflectionalCandidate candidate,
                     const DistanceField& field, const PlaneFitOptions& fit,
                     const ReflectionalSegmentationOptions& options) {
  candidate.support = part.in_part(candidate.support);
  const ReflectionalCutter cutter({part.cloud, part.edges, field}, fit, options);
  Outcome outcome = cutter.segment(candidate);
  std::visit([&](auto& cut) { cut.points = part.in_whole(cut.points); }, outcome);
  return outcome;
}

}  // namespace

void ReflectionalSegmentationOptions::validate() const {
  check_fields(*this);
  require_score_ranges(*this);
  require_option(full_weight_angle < zero_weight_angle, "zero_weight_angle",
                 "an angle above full_weight_angle", zero_weight_angle);
  require_option(pair_weight * edge_factor < 8000.0, "pair_weight",
                 "a weight that times edge_factor is below 8000", pair_weight);
}

SegmentedHypotheses segment_reflectional(const ObservedSurface& surface,
                                         const std::vector<ReflectionalCandidate>& candidates,
                                         const PlaneFitOptions& fit,
                                         const ReflectionalSegmentationOptions& options) {
  options.validate();
  const Neighborhoods neighborhoods(surface, options.neighborhood);
  const ReflectionalCutter whole(surface, fit, options);
  std::vector<Outcome> outcomes(candidates.size());
  parallel_for_each(candidates.size(), [&](std::size_t c) {
    const auto part = neighborhoods.around(candidates[c].support);
    outcomes[c] = part ? segment_part(*part, candidates[c], surface.field, fit, options)
                       : whole.segment(candidates[c]);
  });
  SegmentedHypotheses segmented;
  for (Outcome& outcome : outcomes) {
    if (auto* hypothesis = std::get_if<Hypothesis>(&outcome)) {
      segmented.hypotheses.push_back(std::move(*hypothesis));
    } else {
      segmented.rejected.push_back(std::get<Rejection>(std::move(outcome)));
    }
  }
  return segmented;
}

}  // namespace symscene
