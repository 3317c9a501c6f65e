#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/image_checks.hpp"
#include "core/median.hpp"
#include "factor_fit.hpp"
#include "symscene/core/error.hpp"
#include "wall_view.hpp"

namespace symscene {
namespace {

constexpr float converged = 2e-5F;  ///< greatest change of a factor in a round

float greatest_change(const DepthCorrection& a, const DepthCorrection& b) {
  float change = 0.0F;
  for (std::size_t i = 0; i < a.factors.size(); ++i)
    change = std::max(change, std::abs(a.factors[i] - b.factors[i]));
  return change;
}

}  // namespace

struct WallCalibrator::Implementation {
  CameraIntrinsics camera;
  DepthCorrectionOptions grid;
  WallFitOptions fit;
  std::vector<WallView> views;

  /// Keeps the samples on the wall, with the tolerance of the first search.
  void find_wall(WallView& view, std::size_t number) const {
    view.report.number = number;
    view.measured = view.samples.size();
    const auto plane = view.truth ? view.truth
                                  : search_plane(view.samples, camera, fit.tolerance, fit.draws,
                                                 Random(fit.seed, number));
    if (!plane) {
      view.report.reason = "too little is measured";
      return;
    }
    std::erase_if(view.samples, [&](const DepthSample& s) {
      return !(std::abs(plane->error(camera.ray(s.u, s.v), s.depth)) < fit.tolerance);
    });
    std::vector<float> depths;
    for (const DepthSample& s : view.samples) depths.push_back(s.depth);
    view.report.distance = median(std::move(depths)).value_or(0.0F);
    view.report.share = view.measured == 0 ? 0.0
                                           : static_cast<double>(view.samples.size()) /
                                                 static_cast<double>(view.measured);
    view.report.used = !view.samples.empty() && view.report.share >= fit.min_share;
    if (!view.report.used)
      view.report.reason =
          fmt::format("{:.0f} % of what is measured is a plane", 100.0 * view.report.share);
  }

  std::vector<const WallView*> used_views() const {
    std::vector<const WallView*> used;
    for (const WallView& view : views) {
      if (view.report.used) used.push_back(&view);
    }
    return used;
  }

  void require_views(const std::vector<const WallView*>& used) const {
    if (used.size() < static_cast<std::size_t>(fit.min_views))
      throw InputError(
          "views of a wall",
          fmt::format("at least {} images in which a flat wall or board fills most of what is "
                      "measured (record it from the nearest to the farthest distance of use)",
                      fit.min_views),
          fmt::format("{} of {}", used.size(), views.size()));
    const auto [near, far] =
        std::minmax_element(used.begin(), used.end(), [](const WallView* a, const WallView* b) {
          return a->report.distance < b->report.distance;
        });
    const double least = (*near)->report.distance, greatest = (*far)->report.distance;
    if (greatest >= fit.min_spread * least) return;
    throw InputError("views of a wall",
                     "several distances (record it from the nearest to the farthest distance of "
                     "use: errors grow with range)",
                     fmt::format("all between {:.2f} and {:.2f} m", least, greatest));
  }

  DepthCorrection grid_over(const std::vector<const WallView*>& used) const {
    float least = std::numeric_limits<float>::max(), greatest = 0.0F;
    for (const WallView* view : used) {
      for (const DepthSample& s : view->samples)
        least = std::min(least, s.depth), greatest = std::max(greatest, s.depth);
    }
    return empty_correction(camera, double{least}, double{greatest}, grid);
  }

  /// The plane of a view as the correction so far shows it, and the tolerance around it.
  std::pair<InverseDepthPlane, double> plane_of(const WallView& view,
                                                const DepthCorrection& correction) const {
    if (view.truth)
      return {*view.truth, tolerance_of(errors_of(view, correction, *view.truth, camera))};
    InverseDepthPlane plane = refitted(view, correction, {}, 2.0, camera);
    double tolerance = fit.tolerance;
    for (int i = 0; i < 3; ++i) {
      tolerance = tolerance_of(errors_of(view, correction, plane, camera));
      plane = refitted(view, correction, plane, tolerance, camera);
    }
    return {plane, tolerance};
  }

  void add_samples(const WallView& view, const DepthCorrection& correction,
                   std::vector<FactorSample>& samples) const {
    const auto [plane, tolerance] = plane_of(view, correction);
    for (const DepthSample& s : view.samples) {
      const Eigen::Vector3d ray = camera.ray(s.u, s.v);
      const double z = s.depth * correction.factor(s.u, s.v, s.depth);
      if (std::abs(plane.error(ray, z)) > tolerance) continue;
      samples.push_back({s, plane.depth(ray) / s.depth, 1.0});
    }
  }

  double error_of(const WallView& view, const DepthCorrection& correction) const {
    const auto [plane, tolerance] = plane_of(view, correction);
    return root_mean_square(errors_of(view, correction, plane, camera), tolerance);
  }
};

WallCalibrator::WallCalibrator(const CameraIntrinsics& camera, const DepthCorrectionOptions& grid,
                               const WallFitOptions& fit)
    : implementation_(std::make_unique<Implementation>(Implementation{camera, grid, fit, {}})) {
  grid.validate();
  fit.validate();
}
WallCalibrator::~WallCalibrator() = default;
WallCalibrator::WallCalibrator(WallCalibrator&&) noexcept = default;

void WallCalibrator::add(const std::vector<float>& depth, const std::optional<Plane>& plane) {
  Implementation& own = *implementation_;
  require_pixels(depth.size(), own.camera, "depth image");
  WallView view;
  view.samples = depth_samples(depth, own.camera, own.grid);
  if (plane) view.truth = seen_plane(*plane);
  own.find_wall(view, own.views.size());
  own.views.push_back(std::move(view));
}

DepthCalibration WallCalibrator::calibrate() const {
  const Implementation& own = *implementation_;
  const std::vector<const WallView*> used = own.used_views();
  own.require_views(used);
  DepthCalibration result;
  const DepthCorrection none = own.grid_over(used);
  result.correction = none;
  for (int round = 0; round < own.fit.rounds; ++round) {
    std::vector<FactorSample> samples;
    for (const WallView* view : used) own.add_samples(*view, result.correction, samples);
    DepthCorrection next = fitted(none, samples, own.grid);
    const bool is_done = greatest_change(result.correction, next) < converged;
    result.correction = std::move(next);
    if (is_done) break;
  }
  result.is_absolute = std::all_of(used.begin(), used.end(),
                                   [](const WallView* view) { return view->truth.has_value(); });
  double before = 0.0, after = 0.0;
  for (const WallView& view : own.views) {
    DepthViewReport report = view.report;
    if (report.used) {
      report.error_before = own.error_of(view, none);
      report.error_after = own.error_of(view, result.correction);
      before += report.error_before * report.error_before;
      after += report.error_after * report.error_after;
    }
    result.views.push_back(std::move(report));
  }
  result.error_before = std::sqrt(before / static_cast<double>(used.size()));
  result.error_after = std::sqrt(after / static_cast<double>(used.size()));
  if (!result.is_absolute)
    result.warnings.push_back(
        "the distances of the wall are not known: the warp is corrected, a factor common to all "
        "depths is not (images of a board on the wall show its distance)");
  return result;
}

}  // namespace symscene
