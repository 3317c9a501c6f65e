#include "hand_collision.hpp"

#include <limits>

#include "tool_points.hpp"

namespace symscene {
namespace {

/// The search for the least distance of one pose.
class DistanceSearch {
 public:
  DistanceSearch(const SurfaceSamples& samples, const Eigen::Isometry3f& T_tool_world,
                 std::span<const HandBox> boxes, const DistanceBounds& bounds)
      : samples_(samples),
        T_tool_world_(T_tool_world),
        boxes_(boxes),
        enough_(bounds.enough),
        least_(bounds.irrelevant) {}

  float least() {
    const PointBlocks& blocks = samples_.blocks;
    const HandBox hand = box_around(boxes_);
    for (Eigen::Index begin = 0; begin < blocks.size(); begin += ToolPoints::capacity) {
      const ToolPoints centres(blocks.centres, begin, blocks.size(), T_tool_world_);
      const ToolPoints::Values distances =
          centres.distance_from_faces(hand) - blocks.radii.segment(begin, centres.size());
      for (Eigen::Index i = 0; i < centres.size(); ++i) {
        if (distances[i] < least_) visit_block(begin + i, centres[i]);
        if (least_ < enough_) return least_;
      }
    }
    return least_;
  }

 private:
  void visit_block(Eigen::Index block, const Eigen::Vector3f& centre) {
    for (const HandBox& box : boxes_) {
      if (box.distance(centre) - samples_.blocks.radii[block] >= least_) continue;
      const Eigen::Index end = samples_.blocks.end(block);
      for (Eigen::Index i = samples_.blocks.begin(block); i < end; i += ToolPoints::capacity) {
        visit_points(ToolPoints(samples_.positions, i, end, T_tool_world_), box);
        if (least_ < enough_) return;
      }
    }
  }

  void visit_points(const ToolPoints& points, const HandBox& box) {
    const ToolPoints::Values at_least = points.distance_from_faces(box);
    if (at_least.minCoeff() >= least_) return;
    for (Eigen::Index i = 0; i < points.size() && least_ >= enough_; ++i) {
      if (at_least[i] < least_) least_ = std::min(least_, box.distance(points[i]));
    }
  }

  const SurfaceSamples& samples_;
  const Eigen::Isometry3f& T_tool_world_;
  std::span<const HandBox> boxes_;
  float enough_;
  float least_;
};

}  // namespace

float least_distance(const SurfaceSamples& samples, const Eigen::Isometry3f& T_tool_world,
                     std::span<const HandBox> boxes, const DistanceBounds& bounds) {
  return DistanceSearch(samples, T_tool_world, boxes, bounds).least();
}

double height_over(const Plane& table, const Eigen::Isometry3d& T_world_tool,
                   std::span<const HandBox> boxes) {
  const Eigen::Vector3d normal = T_world_tool.linear().transpose() * table.normal;
  const double origin = table.signed_distance(T_world_tool.translation());
  double least = std::numeric_limits<double>::infinity();
  for (const HandBox& box : boxes) {
    least = std::min(least, origin + normal.dot(box.centre.cast<double>()) -
                                normal.cwiseAbs().dot(box.half.cast<double>()));
  }
  return least;
}

}  // namespace symscene
