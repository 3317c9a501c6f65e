#include "failure_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "symscene/io/image.hpp"

namespace symscene {
namespace {

constexpr Index width = 240, height = 180;  // [px]
constexpr float margin = 1.5F;              // around the shown points, times their radius
constexpr double least_share = 0.1;  // of the object's points that an object in its place has
constexpr double elevation = 0.6;    // of the view [rad]

/// The last three are for points that the object has in common with chosen ones, in turn.
enum class Shade : std::uint8_t { other, missed, foreign, first, second, third };
constexpr std::size_t common_shades = 3;
constexpr std::array<std::array<std::uint8_t, 3>, 6> shades{
    {{170, 176, 184}, {196, 40, 32}, {40, 96, 200}, {30, 140, 84}, {225, 160, 30}, {140, 80, 190}}};

/// The objects that have a tenth of the mask or more, with the number of points in common.
struct Replacement {
  std::size_t id;
  std::size_t common;
};
std::vector<Replacement> replacements(const PointIndices& mask, const SegmentationResult& result) {
  std::vector<Replacement> found;
  for (std::size_t id = 0; id < result.objects.size(); ++id) {
    const std::size_t common = intersection_size(mask, result.objects[id].points);
    if (static_cast<double>(common) >= least_share * static_cast<double>(mask.size()))
      found.push_back({id, common});
  }
  return found;
}

std::string in_words(const PointIndices& mask, const std::vector<Replacement>& found,
                     const SegmentationResult& result) {
  if (found.empty())
    return fmt::format("nothing: no object has a tenth of its {} points", mask.size());
  std::string text;
  for (const Replacement& each : found) {
    text += fmt::format("{}object {} with {} points, {} of its {}", text.empty() ? "" : "; ",
                        each.id, result.objects[each.id].points.size(), each.common, mask.size());
  }
  return text;
}

std::vector<Shade> shades_of(const PointIndices& mask, const std::vector<Replacement>& found,
                             const SegmentationResult& result) {
  std::vector<Shade> shown(result.cloud.size(), Shade::other);
  for (const Index i : mask) shown[i] = Shade::missed;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto own = static_cast<std::size_t>(Shade::first) + (k % common_shades);
    for (const Index i : result.objects[found[k].id].points) {
      if (shown[i] == Shade::missed) shown[i] = static_cast<Shade>(own);
      if (shown[i] == Shade::other) shown[i] = Shade::foreign;
    }
  }
  return shown;
}

/// Axes of the picture in the world: right, down and away from the viewer, who stands where most
/// normals point.
Eigen::Matrix3f axes_of_view(const SegmentationResult& result) {
  const Eigen::Vector3f up = result.table ? result.table->normal.normalized().cast<float>().eval()
                                          : Eigen::Vector3f::UnitZ();
  Eigen::Vector3f front = Eigen::Vector3f::Zero();
  if (result.cloud.normals.rows() > 0) front = result.cloud.normals.colwise().mean().transpose();
  front -= front.dot(up) * up;
  if (front.norm() < 0.05F) front = up.unitOrthogonal();
  front.normalize();
  const auto rise = static_cast<float>(elevation);
  Eigen::Matrix3f axes;
  axes.col(2) = -(std::cos(rise) * front + std::sin(rise) * up);
  axes.col(0) = up.cross(front);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

/// What the picture frames: the points of the object and of what was chosen in its place.
struct Frame {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius = 0.05F;  // [m]
};
Frame frame_of(const PointIndices& mask, const PointCloud& cloud, const std::vector<Shade>& shown) {
  Frame frame;
  for (const Index i : mask) frame.center += cloud.position(i) / static_cast<float>(mask.size());
  for (Index i = 0; i < cloud.size(); ++i) {
    if (shown[i] == Shade::other) continue;
    frame.radius = std::max(frame.radius, (cloud.position(i) - frame.center).norm());
  }
  return frame;
}

/// A picture whose nearest points win.
class Canvas {
 public:
  Canvas() : nearest_(std::size_t{width} * height, std::numeric_limits<float>::infinity()) {
    image_.size = {width, height};
    image_.pixels = Colors::Constant(static_cast<Eigen::Index>(image_.size.pixels()), 3, 255);
  }

  /// A dot of 3 × 3 pixels.
  void dot(const Eigen::Vector3f& at, const std::array<std::uint8_t, 3>& color) {
    for (int dv = -1; dv <= 1; ++dv) {
      for (int du = -1; du <= 1; ++du)
        set(static_cast<int>(at.x()) + du, static_cast<int>(at.y()) + dv, at.z(), color);
    }
  }

  const ColorImage& image() const { return image_; }

 private:
  void set(int u, int v, float depth, const std::array<std::uint8_t, 3>& color) {
    if (u < 0 || v < 0 || u >= static_cast<int>(width) || v >= static_cast<int>(height)) return;
    const auto pixel = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
    if (depth >= nearest_[pixel]) return;
    nearest_[pixel] = depth;
    for (Eigen::Index k = 0; k < 3; ++k)
      image_.pixels(static_cast<Eigen::Index>(pixel), k) = color[static_cast<std::size_t>(k)];
  }

  ColorImage image_;
  std::vector<float> nearest_;
};

std::string picture_of(const PointIndices& mask, const SegmentationResult& result,
                       const std::vector<Shade>& shown) {
  const PointCloud& cloud = result.cloud;
  const Frame frame = frame_of(mask, cloud, shown);
  const Eigen::Matrix3f axes = axes_of_view(result);
  const float scale = static_cast<float>(height) / (2.0F * margin * frame.radius);
  Canvas canvas;
  for (Index i = 0; i < cloud.size(); ++i) {
    Eigen::Vector3f at = scale * (axes.transpose() * (cloud.position(i) - frame.center));
    at += Eigen::Vector3f(0.5F * width, 0.5F * height, 0.0F);
    canvas.dot(at, shades.at(static_cast<std::size_t>(shown[i])));
  }
  return format_png(canvas.image());
}

}  // namespace

void show_failure(const PointIndices& mask, const SegmentationResult& result,
                  ObjectOutcome& outcome) {
  if (outcome.outcome == Outcome::found || mask.empty()) return;
  const std::vector<Replacement> found = replacements(mask, result);
  outcome.instead = in_words(mask, found, result);
  outcome.picture = picture_of(mask, result, shades_of(mask, found, result));
}

}  // namespace symscene
