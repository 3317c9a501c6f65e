#include "single_view_scene.hpp"

#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "core/image_checks.hpp"
#include "core/pixel_showing.hpp"

namespace symscene {
namespace {

/// The label at a point, in a hole that at its border; 0 if the pixel shows another surface.
std::uint16_t label_at(const LabeledFrame& labeled, const Eigen::Vector3d& point_camera,
                       double tolerance) {
  const auto pixel = pixel_showing(point_camera, labeled.frame.depth, labeled.camera);
  if (!pixel) return 0;
  const double depth = labeled.frame.depth[*pixel];
  return std::abs(depth - point_camera.z()) <= tolerance ? labeled.labels[*pixel]
                                                         : std::uint16_t{0};
}

/// The labels of the objects in an image, ascending.
std::set<std::uint16_t> object_labels(const LabeledFrame& labeled) {
  std::set<std::uint16_t> labels(labeled.labels.begin(), labeled.labels.end());
  labels.erase(0);
  return labels;
}

SceneTruth truth_of(const LabeledFrame& labeled, const Scene& scene,
                    const SingleViewOptions& options) {
  std::map<std::uint16_t, PointIndices> masks;
  for (const std::uint16_t label : object_labels(labeled)) masks[label];
  for (Index i = 0; i < scene.cloud.size(); ++i) {
    const Eigen::Vector3d point = scene.cloud.position(i).cast<double>();
    const std::uint16_t label = label_at(labeled, point, options.label_depth);
    if (label != 0) masks[label].push_back(i);
  }
  SceneTruth truth;
  if (scene.table) truth.table = *scene.table;
  for (auto& [label, points] : masks) {
    TrueObject object;
    object.name = fmt::format("object {}", label);
    for (const Index i : points) object.centroid += scene.cloud.position(i).cast<double>();
    if (!points.empty()) object.centroid /= static_cast<double>(points.size());
    object.points = std::move(points);
    truth.objects.push_back(std::move(object));
  }
  return truth;
}

/// Per object why it has no point in the scene's cloud; empty if it has one.
std::vector<std::string> reasons_of_loss(const LabeledFrame& labeled, const SceneTruth& truth,
                                         const ViewPoints& points) {
  std::set<std::uint16_t> on_surface;
  for (const Index pixel : points.pixels) on_surface.insert(labeled.labels[pixel]);
  std::vector<std::string> reasons;
  std::size_t k = 0;
  for (const std::uint16_t label : object_labels(labeled)) {
    const bool is_lost = truth.objects[k++].points.empty();
    const char* reason = on_surface.contains(label) ? "outside the crop" : "no surface";
    reasons.emplace_back(is_lost ? reason : "");
  }
  return reasons;
}

}  // namespace

SingleViewScene single_view_scene(const LabeledFrame& labeled, const SingleViewOptions& options) {
  options.validate();
  require_pixels(labeled.frame.depth.size(), labeled.camera, "depth image");
  require_pixels(labeled.labels.size(), labeled.camera, "label image");
  SingleViewScene result;
  ViewScene view = view_scene({labeled.frame, labeled.camera}, options.view);
  result.scene = std::move(view.built.scene);
  result.truth = truth_of(labeled, result.scene, options);
  result.lost = reasons_of_loss(labeled, result.truth, view.points);
  return result;
}

}  // namespace symscene
