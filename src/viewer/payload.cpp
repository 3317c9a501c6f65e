#include "payload.hpp"

#include "core/base64.hpp"
#include "core/little_endian.hpp"
#include "core/rejected_points.hpp"
#include "encoding.hpp"
#include "grasp_payload.hpp"
#include "scan_payload.hpp"
#include "symscene/core/error.hpp"
#include "symscene/viewer/page_surface.hpp"
#include "view_payload.hpp"

namespace symscene {
namespace {

using nlohmann::json;

constexpr Index closed_triangles = 120000;  // of the closed surfaces of all objects: 1 MB

json to_json(const PointCloud& cloud) {
  return {{"positions", encode_positions(cloud.positions)},
          {"normals", encode_normals(cloud.normals)},
          {"colors", encode_colors(cloud.colors)}};
}

std::string indices(const char* what, const PointIndices& points, Index count) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(points.size() * 4);
  for (const Index i : points) {
    if (i >= count) {
      throw InputError(what, "indices below " + std::to_string(count), std::to_string(i));
    }
    append_little_endian(bytes, i);
  }
  return base64(bytes);
}

json to_json(const ObjectAxis& scored) {
  return {{"point", encode(scored.axis.point)},
          {"direction", encode(scored.axis.direction)},
          {"residual", scored.residual}};
}

json to_json(const ObjectPlane& scored) {
  return {{"point", encode(scored.plane.point)},
          {"normal", encode(scored.plane.normal)},
          {"residual", scored.residual}};
}

json to_json(const Dimension& dimension) {
  json result = {{"name", dimension.name}};
  result[dimension.sigma ? "value" : "at_least"] = dimension.value;
  if (dimension.sigma) result["sigma"] = *dimension.sigma;
  if (!dimension.reason.empty()) result["reason"] = dimension.reason;
  return result;
}

json to_json(const FunnelStep& step) { return {{"step", step.step}, {"count", step.count}}; }

json to_json(const StageTime& time) { return {{"stage", time.stage}, {"seconds", time.seconds}}; }

json to_json(const ScoreEffect& each) {
  return {{"feature", each.feature},
          {"value", each.value},
          {"median", each.median},
          {"effect", each.effect}};
}

template <class Item>
json list(const std::vector<Item>& items) {
  json result = json::array();
  for (const Item& item : items) result.push_back(to_json(item));
  return result;
}

json to_json(const Rejection& rejection, Index count) {
  return {{"kind", rejection.kind},
          {"reason", rejection.reason},
          {"value", rejection.value},
          {"bound", rejection.bound},
          {"size", rejection.size},
          {"points", indices("a rejected hypothesis's points", kept_points(rejection), count)},
          {"effects", list(rejection.score_effects)}};
}

json class_payload(const std::optional<ObjectClass>& found) {
  if (!found) return nullptr;
  json axes = json::array();
  for (int k = 0; k < 3; ++k) axes.push_back(encode(found->axes.col(k)));
  return {{"name", to_string(found->kind)},
          {"center", encode(found->center)},
          {"axes", axes},
          {"order", found->order},
          {"dimensions", list(found->dimensions)}};
}

json pose_payload(const std::optional<ObjectBox>& box) {
  if (!box) return nullptr;
  const Eigen::Vector4d turn = box->T_world_object.orientation.coeffs();  // x, y, z, w
  return {{"position", encode(box->T_world_object.position)},
          {"orientation", {turn.x(), turn.y(), turn.z(), turn.w()}},
          {"size", encode(box->size)}};
}

/// What an object is shown with.
struct ShownObject {
  const SceneObject& object;
  const PointCloud& completed;
  const ObjectSurface& surface;
};

json to_json(const ShownObject& shown, std::size_t id, Index count, Index max_triangles) {
  const SceneObject& object = shown.object;
  return {{"id", id},
          {"score", object.rank()},
          {"points", indices("an object's points", object.points, count)},
          {"effects", list(object.score_effects)},
          {"pose", pose_payload(object.box)},
          {"rotational", list(object.rotational)},
          {"reflectional", list(object.reflectional)},
          {"class", class_payload(object.symmetry_class)},
          {"centroid", object.centroid ? json(encode(*object.centroid)) : json(nullptr)},
          {"volume", object.solid ? json(object.solid->volume) : json(nullptr)},
          {"closed", closed_payload(shown.surface, max_triangles)},
          {"completed", to_json(shown.completed)}};
}

void require_one_each(const char* what, std::size_t count, std::size_t objects) {
  if (count == 0 || count == objects) return;
  throw InputError("the page", std::string(what) + " for every object or for none",
                   std::to_string(count) + " of " + std::to_string(objects));
}

json objects(const SegmentationResult& result) {
  const std::size_t count = result.objects.size();
  require_one_each("completed points", result.completed.size(), count);
  require_one_each("surfaces", result.surfaces.size(), count);
  const Index max_triangles = count == 0 ? 0 : closed_triangles / static_cast<Index>(count);
  static const PointCloud no_points;
  static const ObjectSurface no_surface;
  json list = json::array();
  for (std::size_t id = 0; id < count; ++id) {
    const PointCloud& completed = result.completed.empty() ? no_points : result.completed[id];
    const ObjectSurface& surface = result.surfaces.empty() ? no_surface : result.surfaces[id];
    list.push_back(
        to_json({result.objects[id], completed, surface}, id, result.cloud.size(), max_triangles));
  }
  return list;
}

json rejections(const SegmentationResult& result) {
  json list = json::array();
  for (const Rejection& rejection : result.rejected)
    list.push_back(to_json(rejection, result.cloud.size()));
  return list;
}

json truth_payload(const std::vector<PageTruth>& truth, Index count) {
  if (truth.empty()) return nullptr;
  json list = json::array();
  for (const PageTruth& object : truth) {
    list.push_back({{"name", object.name},
                    {"points", indices("the points of a true object", object.points, count)}});
  }
  return list;
}

json surface(const SegmentationResult& result, const PageOptions& options) {
  if (options.surface.triangles.rows() == 0) return nullptr;
  return surface_payload(page_surface(options.surface, result));
}

}  // namespace

json make_payload(const SegmentationResult& result, const PageOptions& options) {
  options.validate();
  const double length = options.table ? options.table->normal.norm() : 1.0;
  const Eigen::Vector3d up = options.table
                                 ? Eigen::Vector3d(options.table->normal / length)
                                 : options.up.value_or(Eigen::Vector3d::UnitZ()).normalized();
  return {{"version", 1},
          {"title", options.title},
          {"note", options.note},
          {"noun", options.noun},
          {"up", encode(up)},
          {"table", options.table ? json(-options.table->offset / length) : json(nullptr)},
          {"cloud", to_json(result.cloud)},
          {"objects", objects(result)},
          {"surface", surface(result, options)},
          {"trajectory", trajectory_payload(options.trajectory)},
          {"grasps", grasp_payload(options.grasps, result.objects.size())},
          {"views", view_payload(options.views)},
          {"timings", list(result.timings)},
          {"funnel", list(result.funnel)},
          {"rejected", rejections(result)},
          {"truth", truth_payload(options.truth, result.cloud.size())},
          {"sweep", sweep_payload(options.sweep)},
          {"warnings", result.warnings}};
}

}  // namespace symscene
