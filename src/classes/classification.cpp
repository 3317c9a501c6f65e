#include "symscene/classes/classification.hpp"

#include "classes/classification_among.hpp"

#include <algorithm>
#include <cmath>

#include "initial_surfaces.hpp"
#include "listed_class.hpp"
#include "surface_class.hpp"

namespace symscene {
namespace {

constexpr Index least_points = 40;
constexpr double least_scale = 0.03;  // of residuals, in spacings
// Difference of the criterion against the worse of two surfaces (Kass and Raftery 1995: very
// strong).
constexpr double strong_evidence = 10.0;

FitBounds fit_bounds(const FitSamples& samples, const ClassifiedObject& object,
                     const ClassOptions& options) {
  const double patch = options.correlation * options.correlation;
  return {.tolerance = std::max(options.tolerance_spacing * object.spacing,
                                options.tolerance_size * samples.diagonal),
          .face_cosine = std::cos(options.face_angle),
          .min_face_share = options.min_face_share,
          .min_scale = least_scale * object.spacing,
          .correlated = std::max(1.0, patch / samples.thinning)};
}

std::vector<Eigen::Vector3d> known_directions(const ClassifiedObject& object) {
  std::vector<Eigen::Vector3d> directions;
  for (const ObjectAxis& axis : object.axes) directions.push_back(axis.axis.direction);
  if (object.table) directions.push_back(object.table->normal);
  return directions;
}

/// Fits that explain the points, the best first.
std::vector<SurfaceFit> explaining_fits(const ClassifiedObject& object, const FitSamples& samples,
                                        const FitBounds& bounds, const ClassOptions& options) {
  std::vector<SurfaceFit> fits;
  for (const SurfaceModel& initial : initial_surfaces(samples, known_directions(object), bounds)) {
    const std::optional<SurfaceFit> fit = fit_surface(initial, samples, bounds);
    if (fit && fit->explained >= options.min_explained) fits.push_back(*fit);
  }
  std::stable_sort(fits.begin(), fits.end(), [](const SurfaceFit& a, const SurfaceFit& b) {
    return a.criterion < b.criterion;
  });
  return fits;
}

/// The class of the best fit that leaves space free that was seen empty. If its radius is not
/// determined, one of a further fit that explains the points nearly as well.
std::optional<ObjectClass> best_class(const std::vector<SurfaceFit>& fits,
                                      const ClassifiedObject& object, const PointCloud& others,
                                      const FitBounds& bounds, const ClassOptions& options) {
  std::optional<double> best;
  for (const SurfaceFit& fit : fits) {
    const std::optional<ObjectClass> found = surface_class(fit, object, others, bounds, options);
    if (!found) continue;
    if (!best) best = fit.criterion;
    if (fit.criterion > *best + strong_evidence) break;
    if (has_determined_size(*found, options.max_size_deviation)) return found;
  }
  return std::nullopt;
}

}  // namespace

ObjectClass classify_among(const ClassifiedObject& object, const PointCloud& others,
                           const ClassOptions& options) {
  options.validate();
  if (object.points.size() >= least_points && object.points.has_normals()) {
    const FitSamples samples = fit_samples(object.points, options.fit_points);
    const FitBounds bounds = fit_bounds(samples, object, options);
    const std::optional<ObjectClass> found = best_class(
        explaining_fits(object, samples, bounds, options), object, others, bounds, options);
    if (found) return *found;
  }
  return class_of_symmetries(object, options);
}

ObjectClass classify(const ClassifiedObject& object, const ClassOptions& options) {
  return classify_among(object, PointCloud(), options);
}

}  // namespace symscene
