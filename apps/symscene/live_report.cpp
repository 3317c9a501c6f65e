#include "live_report.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/little_endian.hpp"
#include "counted.hpp"

namespace symscene::app {
namespace {

using Json = nlohmann::ordered_json;

Json objects_json(const LiveUpdate& update) {
  Json objects = Json::array();
  for (std::size_t i = 0; i < update.result.objects.size(); ++i) {
    const SceneObject& object = update.result.objects[i];
    const Eigen::Vector3d center =
        object.centroid.value_or(centroid(update.result.cloud.positions, object.points));
    Json one{{"number", update.identified.numbers[i]},
             {"points", object.points.size()},
             {"score", object.rank()},
             {"center", {center.x(), center.y(), center.z()}},
             {"axes", object.rotational.size()},
             {"planes", object.reflectional.size()}};
    if (object.symmetry_class) one["class"] = to_string(object.symmetry_class->kind);
    objects.push_back(std::move(one));
  }
  return objects;
}

Json changes_json(const IdentifiedObjects& identified) {
  Json changes = Json::array();
  for (const ObjectChange& change : identified.changes)
    changes.push_back({{"number", change.number}, {"kind", to_string(change.kind)}});
  return changes;
}

double seconds_of(const std::vector<StageTime>& stages) {
  double sum = 0.0;
  for (const StageTime& stage : stages) sum += stage.seconds;
  return sum;
}

/// The place of each point's object among the objects, from 1; 0 for none.
std::vector<std::uint16_t> object_of_each_point(const SegmentationResult& result) {
  std::vector<std::uint16_t> places(static_cast<std::size_t>(result.cloud.size()), 0);
  for (std::size_t k = 0; k < result.objects.size(); ++k) {
    for (const Index i : result.objects[k].points)
      places[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(k + 1);
  }
  return places;
}

void append(std::string& bytes, float value) {
  append_little_endian(bytes, std::bit_cast<std::uint32_t>(value));
}

/// Positions as multiples of a step from the corner of their box.
struct Quantization {
  Eigen::Vector3f corner = Eigen::Vector3f::Zero();
  float step = 1.0F;

  explicit Quantization(const Points& points) {
    if (points.rows() == 0) return;
    const Box box = bounding_box(points);
    corner = box.min;
    step = std::max(box.extent().maxCoeff() / 65535.0F, 1e-9F);
  }
  std::uint16_t of(float value, int axis) const {
    return static_cast<std::uint16_t>(
        std::clamp(std::round((value - corner[axis]) / step), 0.0F, 65535.0F));
  }
};

}  // namespace

std::string live_json(const LiveReport& report) {
  const SegmentationResult& result = report.update.result;
  Json json{{"update", report.number},
            {"frames", report.update.frames},
            {"lost", report.lost},
            {"time", report.frame_time},
            {"latency", report.latency},
            {"segmentation", seconds_of(result.timings)},
            {"points", result.cloud.size()},
            {"spacing", report.spacing},
            {"objects", objects_json(report.update)},
            {"changes", changes_json(report.update.identified)},
            {"warnings", result.warnings}};
  if (result.table) {
    const Plane& table = *result.table;
    json["table"] = {table.normal.x(), table.normal.y(), table.normal.z(), table.offset};
  }
  if (!report.problem.empty()) json["problem"] = report.problem;
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::string live_line(const LiveReport& report) {
  const std::string after = fmt::format("after {}", counted(report.update.frames, "frame"));
  if (!report.problem.empty()) return fmt::format("{}: no scene yet: {}", after, report.problem);
  std::string line =
      fmt::format("{}: {}, {:.2f} s after the last frame", after,
                  counted(report.update.result.objects.size(), "object"), report.latency);
  for (const ObjectChange& change : report.update.identified.changes)
    line += fmt::format("; {} {}", change.number, to_string(change.kind));
  return line;
}

std::string live_bytes(const LiveReport& report, std::size_t most) {
  const PointCloud& cloud = report.update.result.cloud;
  const auto size = static_cast<std::size_t>(cloud.size());
  const std::size_t count = std::min(size, most);
  const std::vector<std::uint16_t> places = object_of_each_point(report.update.result);
  const Quantization quantized(cloud.positions);
  std::string json = live_json(report);
  json.resize((json.size() + 3) / 4 * 4, ' ');  // what follows is aligned
  std::string bytes = "SYL1";
  for (const std::size_t value : {json.size(), count, size, std::size_t{cloud.has_colors()}})
    append_little_endian(bytes, static_cast<std::uint32_t>(value));
  for (int axis = 0; axis < 3; ++axis) append(bytes, quantized.corner[axis]);
  append(bytes, quantized.step);
  bytes += json;
  const auto nth = [&](std::size_t k) { return static_cast<Index>(k * size / count); };
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector3f position = cloud.position(nth(k));
    for (int axis = 0; axis < 3; ++axis)
      append_little_endian(bytes, quantized.of(position[axis], axis));
    append_little_endian(bytes, places[static_cast<std::size_t>(nth(k))]);
  }
  for (std::size_t k = 0; cloud.has_colors() && k < count; ++k) {
    for (int channel = 0; channel < 3; ++channel)
      append_little_endian(bytes, cloud.colors(nth(k), channel));
  }
  return bytes;
}

}  // namespace symscene::app
