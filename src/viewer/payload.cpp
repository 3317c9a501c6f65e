#include "payload.hpp"

#include "base64.hpp"
#include "encoding.hpp"
#include "scan_payload.hpp"
#include "symscene/core/error.hpp"
#include "symscene/viewer/page_surface.hpp"

namespace symscene {
namespace {

using nlohmann::json;

json to_json(const PointCloud& cloud) {
  return {{"positions", encode_positions(cloud.positions)},
          {"normals", encode_normals(cloud.normals)},
          {"colors", encode_colors(cloud.colors)}};
}

std::string indices(const PointIndices& points, Index count) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(points.size() * 4);
  for (const Index i : points) {
    if (i >= count) {
      throw InputError("an object's points", "indices below " + std::to_string(count),
                       std::to_string(i));
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

json to_json(const FunnelStep& step) { return {{"step", step.step}, {"count", step.count}}; }

json to_json(const StageTime& time) { return {{"stage", time.stage}, {"seconds", time.seconds}}; }

json to_json(const Rejection& rejection) {
  return {{"kind", rejection.kind},
          {"reason", rejection.reason},
          {"value", rejection.value},
          {"bound", rejection.bound},
          {"size", rejection.size}};
}

template <class Item>
json list(const std::vector<Item>& items) {
  json result = json::array();
  for (const Item& item : items) result.push_back(to_json(item));
  return result;
}

json to_json(const SceneObject& object, std::size_t id, const PointCloud& completed, Index count) {
  return {{"id", id},
          {"score", object.rank()},
          {"points", indices(object.points, count)},
          {"rotational", list(object.rotational)},
          {"reflectional", list(object.reflectional)},
          {"centroid", object.centroid ? json(encode(*object.centroid)) : json(nullptr)},
          {"completed", to_json(completed)}};
}

json objects(const SegmentationResult& result) {
  const std::size_t completed = result.completed.size();
  if (completed != 0 && completed != result.objects.size()) {
    throw InputError("the page", "completed points for every object or for none",
                     std::to_string(completed) + " of " + std::to_string(result.objects.size()));
  }
  json list = json::array();
  for (std::size_t id = 0; id < result.objects.size(); ++id) {
    list.push_back(to_json(result.objects[id], id, completed ? result.completed[id] : PointCloud{},
                           result.cloud.size()));
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
          {"up", encode(up)},
          {"table", options.table ? json(-options.table->offset / length) : json(nullptr)},
          {"cloud", to_json(result.cloud)},
          {"objects", objects(result)},
          {"surface", surface(result, options)},
          {"trajectory", trajectory_payload(options.trajectory)},
          {"timings", list(result.timings)},
          {"funnel", list(result.funnel)},
          {"rejected", list(result.rejected)},
          {"warnings", result.warnings}};
}

}  // namespace symscene
