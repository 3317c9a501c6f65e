#include "segmentation/class_segmentation.hpp"

#include <algorithm>

#include "classes/class_surface.hpp"
#include "core/parallel.hpp"
#include "graph_cut.hpp"
#include "labeling.hpp"
#include "symmetry/score_range.hpp"

namespace symscene {
namespace {

constexpr int rounds = 2;

class ClassCutter {
 public:
  ClassCutter(const ObservedSurface& surface, double spacing, const ClassOptions& fit,
              const ClassSegmentationOptions& options)
      : surface_(surface),
        spacing_(spacing),
        fit_(fit),
        options_(options),
        scaled_edges_(surface.edges) {
    fit_.fit_points = options.fit_points;
    for (WeightedEdge& edge : scaled_edges_) edge.weight *= static_cast<float>(options.edge_factor);
  }

  std::optional<ClassHypothesis> segment(const ClassSeed& seed) const {
    ClassHypothesis hypothesis{seed.points, {}};
    for (int round = 0; round < rounds; ++round) {
      const PointCloud points = select(surface_.cloud, hypothesis.points);
      hypothesis.symmetry_class =
          classify({points, spacing_, seed.axes, {}, surface_.field, std::nullopt}, fit_);
      if (hypothesis.symmetry_class.dimensions.empty()) return std::nullopt;
      hypothesis.points = cut(hypothesis.symmetry_class);
      if (hypothesis.points.empty()) return std::nullopt;
    }
    return hypothesis;
  }

 private:
  SurfaceBounds bounds_of(const ObjectClass& symmetry_class) const {
    double longest = 0.0;
    for (const Dimension& dimension : symmetry_class.dimensions)
      longest = std::max(longest, dimension.value);
    const double tolerance =
        std::max(fit_.tolerance_spacing * spacing_, fit_.tolerance_size * longest);
    return {{tolerance, options_.max_distance * tolerance}, angle_range(options_)};
  }

  /// As Eqs. 4.8 and 4.9, with the residual of a point on the surface in place of its image's.
  PointIndices cut(const ObjectClass& symmetry_class) const {
    const ClassSurface surface(symmetry_class);
    const SurfaceBounds bounds = bounds_of(symmetry_class);
    const PointCloud& cloud = surface_.cloud;
    const auto background = static_cast<float>(options_.background_weight);
    std::vector<Affinity> affinities(cloud.size());
    for (Index i = 0; i < cloud.size(); ++i) {
      const float residual = surface.residual(cloud.position(i), cloud.normal(i), bounds);
      affinities[i] = {1.0F - residual, background * residual};
    }
    std::vector<std::uint8_t> is_object = cut_graph(affinities, scaled_edges_).is_object;
    drop_small_components(is_object, scaled_edges_, options_.min_component);
    return object_nodes(is_object);
  }

  const ObservedSurface& surface_;
  double spacing_;
  ClassOptions fit_;
  const ClassSegmentationOptions& options_;
  std::vector<WeightedEdge> scaled_edges_;
};

}  // namespace

void ClassSegmentationOptions::validate() const {
  check_fields(*this);
  require_option(min_angle < max_angle, "max_angle", "an angle above min_angle", max_angle);
}

std::vector<std::optional<ClassHypothesis>> segment_classes(
    const ObservedSurface& surface, double spacing, const std::vector<ClassSeed>& seeds,
    const ClassOptions& fit, const ClassSegmentationOptions& options) {
  options.validate();
  const ClassCutter cutter(surface, spacing, fit, options);
  std::vector<std::optional<ClassHypothesis>> hypotheses(seeds.size());
  parallel_for_each(seeds.size(), [&](std::size_t k) { hypotheses[k] = cutter.segment(seeds[k]); });
  return hypotheses;
}

}  // namespace symscene
