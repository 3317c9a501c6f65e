#include "symscene/clutter/clutter_gallery.hpp"

#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/looking_at.hpp"
#include "simulation/depth_renderer.hpp"
#include "simulation/shapes.hpp"
#include "symscene/grasping/gripper.hpp"

namespace symscene {
namespace {

using Color = std::array<std::uint8_t, 3>;

constexpr std::array<Color, 6> item_colors{{{110, 160, 220},
                                            {130, 190, 120},
                                            {200, 180, 90},
                                            {180, 130, 200},
                                            {110, 190, 190},
                                            {200, 140, 130}}};
constexpr Color gripper_color{255, 140, 0};
constexpr Color ground_color{225, 225, 225};

void set_color(TriangleMesh& mesh, const Color& color) {
  mesh.colors.resize(mesh.vertices.rows(), 3);
  for (int k = 0; k < 3; ++k) mesh.colors.col(k).setConstant(color[static_cast<std::size_t>(k)]);
}

/// A box, given by two corners in a frame.
TriangleMesh box_in(const Eigen::Isometry3d& frame, const Eigen::Vector3d& low,
                    const Eigen::Vector3d& high, const Color& color) {
  const Eigen::Vector3d size = high - low;
  TriangleMesh mesh = make_box(size, size.maxCoeff());
  const Eigen::Vector3f shift =
      (low - bounding_box(mesh.vertices).min.cast<double>()).cast<float>();
  mesh.vertices.rowwise() += shift.transpose();
  const Eigen::Isometry3f T = frame.cast<float>();
  mesh.vertices = (mesh.vertices * T.linear().transpose()).rowwise() + T.translation().transpose();
  set_color(mesh, color);
  return mesh;
}

std::vector<TriangleMesh> gripper_meshes(const Gripper& gripper,
                                         const Eigen::Isometry3d& T_world_tool) {
  const Eigen::Vector3d half = 0.5 * gripper.palm_size;
  const double x = 0.5 * gripper.finger_width, y = 0.5 * gripper.max_opening;
  const double outer = y + gripper.tip_thickness, tip = gripper.finger_depth;
  const auto box = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    return box_in(T_world_tool, low, high, gripper_color);
  };
  return {box({-half.x(), -half.y(), -gripper.palm_size.z()}, {half.x(), half.y(), 0.0}),
          box({-x, y, 0.0}, {x, outer, tip}), box({-x, -outer, 0.0}, {x, -y, tip})};
}

/// A camera above the table that looks along the pads, from the side that is nearer to the camera
/// of one view.
Eigen::Isometry3d image_pose(const Grasp& grasp) {
  Eigen::Vector3d along = grasp.T_world_tool.linear().col(0);
  if (along.head<2>().norm() < 1e-3) along = -Eigen::Vector3d::UnitY();
  if (along.y() > 0.0) along = -along;
  along.z() = 0.0;
  constexpr double distance = 0.55, steepness = 0.7;
  const Eigen::Vector3d outward =
      (along.normalized() + steepness * Eigen::Vector3d::UnitZ()).normalized();
  return looking_along(Eigen::Vector3d(0.15, 0.15, 0.1) + distance * outward, -outward);
}

std::string features_of(const Grasp& grasp) {
  std::string text;
  GraspFeatures::visit_fields(grasp.features, [&](const char* name, double value) {
    text += fmt::format("{} {:.3g}<br>", name, value);
  });
  return text;
}

}  // namespace

ColorImage grasp_image(const ClutterWorld& world, const Grasp& grasp) {
  std::vector<TriangleMesh> meshes = world.surfaces();
  for (std::size_t i = 0; i < meshes.size(); ++i)
    set_color(meshes[i], item_colors[i % item_colors.size()]);
  for (TriangleMesh& part : gripper_meshes(panda_hand(), grasp.T_world_tool))
    meshes.push_back(std::move(part));
  constexpr double height = clutter::table_height;
  meshes.push_back(box_in(Eigen::Isometry3d::Identity(), {-0.2, -0.2, height - 0.01},
                          {0.5, 0.5, height}, ground_color));
  const CameraIntrinsics camera{320, 240, 270.0, 270.0, 159.5, 119.5};
  const SensorFrame frame = DepthRenderer(meshes).render(camera, image_pose(grasp));
  return {{camera.width, camera.height}, frame.colors};
}

std::string format_gallery(const std::string& title, std::span<const GalleryEntry> entries) {
  std::string page = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>{0}</title><style>"
      "body{{font-family:sans-serif;margin:1em}}figure{{display:inline-block;width:320px;"
      "margin:0.5em;vertical-align:top}}figcaption{{font-size:13px}}</style><h1>{0}</h1>\n"
      "<p>{1} attempts. The open gripper is drawn at its grasp.</p>\n",
      title, entries.size());
  for (const GalleryEntry& entry : entries) {
    const ClutterAttempt& a = entry.attempt;
    const std::string contact =
        a.outcome.contact == ApproachContact::none
            ? ""
            : fmt::format(", touched {} {:.0f} mm before the grasp",
                          a.outcome.contact == ApproachContact::table ? "the table"
                          : a.touched_other                           ? "another object"
                                                                      : "its object",
                          1e3 * a.outcome.short_by);
    fmt::format_to(
        std::back_inserter(page),
        "<figure><img src=\"{}\" width=\"320\" height=\"240\" alt=\"round {}, attempt {}\">"
        "<figcaption><b>{}</b>{}<br>round {}, attempt {}: {}, {:.0f} % hidden, {} of {} objects "
        "seen<br>{}, quality {:.2f}, width {:.0f} mm, closed {:.0f} mm, at the end {:.0f} mm"
        "<details><summary>features</summary>{}</details></figcaption></figure>\n",
        entry.image, a.round, a.number, to_string(a.outcome.end), contact, a.round, a.number,
        a.aimed, 100.0 * a.occlusion, a.seen, a.present, to_string(a.grasp.source), a.grasp.quality,
        1e3 * a.grasp.opening, 1e3 * a.outcome.closed_width, 1e3 * a.outcome.width,
        features_of(a.grasp));
  }
  return page + "</html>\n";
}

}  // namespace symscene
