#include "symscene/clutter/graspability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/surface_sampling.hpp"
#include "grasping/gripper_boxes.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::size_t line_starts = 300;
constexpr std::size_t fit_samples = 6000;  // of the surface, which the open hand must not enter
constexpr int approach_directions = 12;    // around a line
constexpr std::array<double, 3> contact_depths{0.01, 0.005, 0.0};  // of lines behind the tips [m]
constexpr double least_contact = 0.002;  // extent of what a pad touches along the finger [m]
constexpr double contact_give = 0.001;   // depth of the surface that a pad touches [m]

/// A point at which a line leaves a solid.
struct LineExit {
  double distance = 0.0;  ///< from the start of the line [m]
  double cosine = 0.0;    ///< of the outward normal with the line
};

Eigen::Vector3d corner(const TriangleMesh& mesh, Eigen::Index triangle, int k) {
  return mesh.vertices.row(mesh.triangles(triangle, k)).transpose().cast<double>();
}

/// Calls use(LineExit) for every triangle at whose back the line leaves the mesh (Möller and
/// Trumbore 1997).
template <class Use>
void for_each_exit(const TriangleMesh& mesh, const Eigen::Vector3d& start,
                   const Eigen::Vector3d& direction, const Use& use) {
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3d a = corner(mesh, t, 0), ab = corner(mesh, t, 1) - a,
                          ac = corner(mesh, t, 2) - a;
    const Eigen::Vector3d normal = ab.cross(ac);
    const double along = normal.dot(direction);
    if (along <= 0.0) continue;
    const Eigen::Vector3d moment = (start - a).cross(direction);
    const double u = -ac.dot(moment) / along, v = ab.dot(moment) / along;
    if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
    use(LineExit{normal.dot(a - start) / along, along / normal.norm()});
  }
}

/// The open hand, tried around lines through an object.
class OpenHand {
 public:
  OpenHand(const TriangleMesh& mesh, const Plane& table, const Gripper& gripper)
      : OpenHand(sample_surface(mesh, fit_samples), table, gripper) {}

  /// `surface`: samples of the object's.
  OpenHand(const PointCloud& surface, const Plane& table, const Gripper& gripper)
      : table_(table),
        surface_(surface.positions.cast<double>().transpose()),
        normals_(surface.normals.cast<double>().transpose()),
        boxes_(gripper_boxes(gripper, gripper.max_opening)),
        between_(box_between_fingers(gripper, gripper.max_opening)),
        finger_depth_(gripper.finger_depth),
        least_cosine_(std::cos(std::atan(gripper.friction))) {
    for (Eigen::AlignedBox3d& box : boxes_) box.min().z() -= gripper.approach_distance;
  }

  /// Adds what one line through the object allows: the hand closes along `closing` about `middle`.
  void try_around(const Eigen::Vector3d& middle, const Eigen::Vector3d& closing,
                  Graspability& result) const {
    // Straight down, or as steeply as the line allows.
    const Eigen::Vector3d down = -table_.normal + table_.normal.dot(closing) * closing;
    const Eigen::Vector3d first =
        down.norm() > 1e-3 ? Eigen::Vector3d(down.normalized()) : closing.unitOrthogonal();
    for (int i = 0; i < approach_directions && !result.as_it_lies; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / approach_directions;
      try_from(Eigen::AngleAxisd(angle, closing) * first, middle, closing, result);
    }
  }

 private:
  /// Tries one direction of approach, as deep as the table allows.
  void try_from(const Eigen::Vector3d& approach, const Eigen::Vector3d& middle,
                const Eigen::Vector3d& closing, Graspability& result) const {
    Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
    T_world_tool.linear() << closing.cross(approach), closing, approach;
    const auto place = [&](double depth) {
      T_world_tool.translation() = middle - std::max(finger_depth_ - depth, 0.0) * approach;
      return is_above_table(T_world_tool);
    };
    const bool is_above = std::any_of(contact_depths.begin(), contact_depths.end(), place);
    if (!is_above) place(contact_depths.front());
    if (result.at_all && !is_above) return;
    const Eigen::Matrix3Xd points = T_world_tool.inverse() * surface_;
    if (enters_object(points) || !can_close(points, closing)) return;
    result.at_all = true;
    result.as_it_lies = is_above;
  }

  bool is_above_table(const Eigen::Isometry3d& T_world_tool) const {
    const Eigen::Vector3d normal = T_world_tool.linear().transpose() * table_.normal;
    const double origin = table_.signed_distance(T_world_tool.translation());
    return std::all_of(boxes_.begin(), boxes_.end(), [&](const Eigen::AlignedBox3d& box) {
      return origin + normal.dot(box.center()) >= 0.5 * normal.cwiseAbs().dot(box.sizes());
    });
  }

  /// `points`: the surface in the tool frame.
  bool enters_object(const Eigen::Matrix3Xd& points) const {
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      for (const Eigen::AlignedBox3d& box : boxes_) {
        if (box.contains(points.col(i))) return true;
      }
    }
    return false;
  }

  /// Whether what both pads touch first is no mere edge and faces them within the friction angle.
  bool can_close(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& closing) const {
    std::vector<Eigen::Index> between;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if (between_.contains(points.col(i))) between.push_back(i);
    }
    const auto faces_pad = [&](double side) {
      double foremost = -std::numeric_limits<double>::infinity();
      for (const Eigen::Index i : between) foremost = std::max(foremost, side * points(1, i));
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      double low = between_.max().z(), high = 0.0;
      for (const Eigen::Index i : between) {
        if (side * points(1, i) < foremost - contact_give) continue;
        normal += normals_.col(i);
        low = std::min(low, points(2, i));
        high = std::max(high, points(2, i));
      }
      return high - low >= least_contact &&
             side * closing.dot(normal) > least_cosine_ * normal.norm();
    };
    return faces_pad(1.0) && faces_pad(-1.0);
  }

  Plane table_;
  Eigen::Matrix3Xd surface_, normals_;
  std::vector<Eigen::AlignedBox3d> boxes_;  ///< swept by the approach
  Eigen::AlignedBox3d between_;
  double finger_depth_, least_cosine_;
};

}  // namespace

Graspability graspability(const TriangleMesh& mesh, const Plane& table, const Gripper& gripper,
                          double min_width) {
  if (gripper.kind != GripperKind::parallel)
    throw InputError(gripper.name, "a parallel gripper", to_string(gripper.kind));
  const PointCloud starts = sample_surface(mesh, line_starts);
  const double least_cosine = std::cos(std::atan(gripper.friction));
  const OpenHand hand(mesh, table, gripper);
  Graspability result;
  for (Index i = 0; i < starts.size() && !result.as_it_lies; ++i) {
    const Eigen::Vector3d start = starts.position(i).cast<double>();
    const Eigen::Vector3d inward = -starts.normal(i).cast<double>();
    for_each_exit(mesh, start, inward, [&](const LineExit& exit) {
      if (exit.distance < min_width || exit.distance > gripper.max_opening) return;
      if (exit.cosine < least_cosine) return;
      hand.try_around(start + 0.5 * exit.distance * inward, inward, result);
    });
  }
  return result;
}

}  // namespace symscene
