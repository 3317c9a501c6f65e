#include "image_sequence.hpp"

#include <cmath>

#include <fmt/format.h>

#include "camera_formats.hpp"
#include "image_formats.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/image.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

std::string size_text(ImageSize size) { return fmt::format("{}×{}", size.width, size.height); }

/// Converts values to metres, 0 where there is no measurement.
std::vector<float> to_metres(const std::vector<std::uint16_t>& values, double scale,
                             std::uint16_t invalid) {
  std::vector<float> depth(values.size());
  const auto divisor = static_cast<float>(scale);
  for (std::size_t i = 0; i < values.size(); ++i) {
    depth[i] = values[i] == invalid ? 0.0F : static_cast<float>(values[i]) / divisor;
  }
  return depth;
}

class ImageSequence final : public DepthSequence {
 public:
  explicit ImageSequence(ImageFrames content)
      : content_(std::move(content)), camera_(*content_.calibration.intrinsics) {
    const ImageSize size = read_image_size(content_.frames.front().depth);
    if (camera_.width == 0) camera_.width = size.width, camera_.height = size.height;
    leave_out_unregistered_colors();
  }

  std::string layout() const override { return content_.layout; }
  const CameraIntrinsics& camera() const override { return camera_; }
  double depth_scale() const override { return *content_.calibration.depth_scale; }
  std::size_t size() const override { return content_.frames.size(); }
  double time(std::size_t i) const override { return content_.frames.at(i).time; }
  bool has_color() const override { return first_color() != nullptr; }
  bool has_color(std::size_t i) const override { return !content_.frames.at(i).color.empty(); }
  std::optional<Eigen::Isometry3d> pose(std::size_t i) const override {
    return content_.frames.at(i).T_world_camera;
  }

  const std::vector<std::string>& warnings() const override { return content_.warnings; }

  DepthFrame read(std::size_t i) const override {
    const ImageFrame& files = content_.frames.at(i);
    const DepthImage image = read_depth_png(files.depth);
    require_size(image.size, camera_size(), files.depth);
    DepthFrame frame;
    frame.time = files.time;
    frame.depth = to_metres(image.values, *content_.calibration.depth_scale, content_.invalid);
    if (files.color.empty()) return frame;
    ColorImage color = read_color_image(files.color);
    require_size(color.size, color_size(), files.color);
    frame.colors = std::move(color.pixels);
    return frame;
  }

 private:
  ImageSize camera_size() const { return {camera_.width, camera_.height}; }

  ImageSize color_size() const { return content_.calibration.color_size.value_or(camera_size()); }

  static void require_size(ImageSize size, ImageSize expected, const fs::path& file) {
    if (size == expected) return;
    throw InputError(file.string(), "an image of the camera's size, " + size_text(expected),
                     size_text(size));
  }

  const ImageFrame* first_color() const {
    for (const ImageFrame& frame : content_.frames) {
      if (!frame.color.empty()) return &frame;
    }
    return nullptr;
  }

  void leave_out_unregistered_colors() {
    const ImageFrame* colored = first_color();
    if (colored == nullptr) return;
    const ImageSize size = read_image_size(colored->color);
    if (size == color_size()) return;
    const char* reason = content_.calibration.color_size
                             ? "{}: colour images of {} are not those of the colour camera, {}: "
                               "read without colour"
                             : "{}: colour images of {} are not registered to depth images of {}: "
                               "read without colour";
    content_.warnings.push_back(fmt::format(fmt::runtime(reason), content_.path.string(),
                                            size_text(size), size_text(color_size())));
    for (ImageFrame& frame : content_.frames) frame.color.clear();
  }

  ImageFrames content_;
  CameraIntrinsics camera_;
};

}  // namespace

std::optional<ImageSize> own_color_size(const SequenceOptions& options) {
  if (!options.camera || !options.camera->color) return std::nullopt;
  const CameraIntrinsics& color = options.camera->color->intrinsics;
  return ImageSize{color.width, color.height};
}

Calibration resolve_calibration(const fs::path& path, const std::string& layout,
                                const Calibration& known, const SequenceOptions& given) {
  const Calibration used{given.intrinsics ? given.intrinsics : known.intrinsics,
                         given.depth_scale ? given.depth_scale : known.depth_scale,
                         own_color_size(given)};
  std::string missing;
  if (!used.intrinsics) missing += " --intrinsics fx,fy,cx,cy (or a camera.yaml)";
  if (!used.depth_scale) missing += " --depth-scale 1000";
  if (!missing.empty()) {
    throw InputError(path.string(),
                     fmt::format("the camera, which the files of this layout ({}) do not give: "
                                 "pass{}",
                                 layout, missing),
                     "none");
  }
  require_camera(*used.intrinsics, path.string() + ": intrinsics");
  if (!(*used.depth_scale > 0.0) || !std::isfinite(1.0F / static_cast<float>(*used.depth_scale))) {
    throw InputError(path.string() + ": depth scale", "a number above 0",
                     fmt::format("{}", *used.depth_scale));
  }
  return used;
}

std::unique_ptr<DepthSequence> make_image_sequence(ImageFrames content) {
  if (content.frames.empty()) {
    throw InputError(content.path.string(),
                     fmt::format("depth images in the layout {}", content.layout), "none");
  }
  return std::make_unique<ImageSequence>(std::move(content));
}

}  // namespace symscene
