#include "mask_images.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "symscene/io/image.hpp"

namespace symscene::app {
namespace {

bool belongs_to_masks(const std::string& file) {
  return file == "masks.json" || file == "labels/" || file == "overlays/" ||
         ((file.starts_with("labels/") || file.starts_with("overlays/")) && file.ends_with(".png"));
}

std::vector<PointIndices> masks_of(const SegmentationResult& result) {
  std::vector<PointIndices> masks;
  for (const SceneObject& object : result.objects) masks.push_back(object.points);
  return masks;
}

}  // namespace

MaskImageWriter::MaskImageWriter(const std::filesystem::path& folder,
                                 const SegmentationResult& result, const LabelImageOptions& options)
    : folder_(folder, {"a masks folder", "masks.json", belongs_to_masks}),
      result_(result),
      points_(result.cloud, result.table, options),
      masks_(masks_of(result)) {}

void MaskImageWriter::add(std::size_t index, const CameraIntrinsics& camera,
                          const DepthFrame& frame, const Eigen::Isometry3d& T_scene_camera) {
  const std::vector<Index> points = points_.points_of(camera, frame.depth, T_scene_camera);
  std::vector<std::uint16_t> labels = label_image(points, masks_, result_.cloud.size());
  const ImageSize size{camera.width, camera.height};
  const std::string name = fmt::format("{:06}.png", index);
  folder_.write("overlays/" + name, format_png(ColorImage{size, overlay(camera, frame, labels)}));
  folder_.write("labels/" + name, format_png(DepthImage{size, std::move(labels)}));
  frames_.push_back(index);
}

void MaskImageWriter::finish() {
  nlohmann::ordered_json json = {{"version", 1}, {"frames", frames_}};
  json["objects"] = nlohmann::ordered_json::array();
  for (std::size_t id = 0; id < result_.objects.size(); ++id) {
    nlohmann::ordered_json object = {{"label", id + 1}, {"object", id}};
    if (const auto& score = result_.objects[id].score) object["score"] = *score;
    json["objects"].push_back(std::move(object));
  }
  folder_.write("masks.json", json.dump(2) + "\n");
  folder_.commit();
}

}  // namespace symscene::app
