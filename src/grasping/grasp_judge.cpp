#include "grasp_judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/retreat.hpp"
#include "grasping/quality.hpp"
#include "hand_collision.hpp"
#include "squared_distances.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr float hand_spacing = 0.012F;       // of the points at which space is looked up [m]
constexpr float greatest_distance = 0.01F;   // that is told from others [m]
constexpr double greatest_tolerance = 0.05;  // of the measured depth [m]
constexpr double gravity = 9.81;             // [m/s²]

void fail(GraspJudge::Verdict& verdict, GraspRejection reason, double value, double bound) {
  verdict.reason = reason;
  verdict.value = value;
  verdict.bound = bound;
}

/// Every n-th row, so that about `count` remain.
Points thinned(const Points& points, Eigen::Index count) {
  const Eigen::Index step = std::max<Eigen::Index>(1, points.rows() / count);
  Points some((points.rows() + step - 1) / step, 3);
  for (Eigen::Index i = 0; i < some.rows(); ++i) some.row(i) = points.row(i * step);
  return some;
}

/// Where a hidden side of another object, which is only inferred, contradicts the target.
class TargetSpace {
 public:
  explicit TargetSpace(const SurfaceSamples& samples)
      : cells_(samples.positions, margin),
        box_(bounding_box(samples.positions).padded(margin)),
        some_positions_(thinned(samples.positions, sign_samples)),
        some_normals_(thinned(samples.normals, sign_samples)) {}

  /// Whether the point lies inside the target or on its surface.
  bool contains(const Eigen::Vector3f& point) const {
    if ((point.array() < box_.min.array()).any() || (point.array() > box_.max.array()).any())
      return false;
    if (cells_.nearest(point, margin).first != CellList::none) return true;
    // Off the surface, a few samples tell the side.
    const Eigen::ArrayXf squared = squared_distances(some_positions_, point);
    const Eigen::Index nearest = first_of(squared, squared.minCoeff());
    return (point.transpose() - some_positions_.row(nearest)).dot(some_normals_.row(nearest)) <
           0.0F;
  }

 private:
  static constexpr float margin = 0.006F;  // of what counts as on the surface [m]
  static constexpr Eigen::Index sign_samples = 300;

  CellList cells_;
  Box box_;
  Points some_positions_;
  Points some_normals_;
};

/// Blocks of samples within reach, without what is inferred inside the target.
class ReachableSamples {
 public:
  ReachableSamples(const Eigen::Vector3f& centre, float reach, const TargetSpace& target)
      : centre_(centre), reach_(reach), target_(target) {}

  void add(const SurfaceSamples& samples) {
    const PointBlocks& blocks = samples.blocks;
    for (Eigen::Index b = 0; b < blocks.size(); ++b) {
      const Eigen::Vector3f centre = blocks.centres.row(b).transpose();
      if ((centre - centre_).norm() > reach_ + blocks.radii[b]) continue;
      for (Eigen::Index i = blocks.begin(b); i < blocks.end(b); ++i) {
        const Eigen::Vector3f position = samples.positions.row(i).transpose();
        if (samples.observed[static_cast<std::size_t>(i)] != 0 || !target_.contains(position))
          positions_.push_back(position);
      }
      centres_.push_back(centre);
      radii_.push_back(blocks.radii[b]);
      ends_.push_back(static_cast<Eigen::Index>(positions_.size()));
    }
  }

  SurfaceSamples samples() const {
    SurfaceSamples near;
    near.positions = as_rows(positions_);
    near.blocks.centres = as_rows(centres_);
    near.blocks.radii =
        Eigen::Map<const Eigen::ArrayXf>(radii_.data(), static_cast<Eigen::Index>(radii_.size()));
    near.blocks.ends = ends_;
    return near;
  }

 private:
  static Points as_rows(const std::vector<Eigen::Vector3f>& points) {
    Points rows(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
      rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return rows;
  }

  Eigen::Vector3f centre_;
  float reach_;
  const TargetSpace& target_;
  std::vector<Eigen::Vector3f> positions_;
  std::vector<Eigen::Vector3f> centres_;
  std::vector<float> radii_;
  std::vector<Eigen::Index> ends_;
};

/// How far beyond an object a gripper reaches on its way to a grasp and away.
float reach_on_way(const Gripper& gripper, const HandShape& swept) {
  const HandShape open = hand_shape(gripper, gripper.max_opening, 0.0);
  return static_cast<float>(gripper.finger_depth) +
         std::max(swept.reach, open.reach + static_cast<float>(gripper.retreat_distance));
}

/// What a hand of that reach can meet at the object, besides the object.
SurfaceSamples reachable_obstacles(const GraspSurroundings& around, const GraspTarget& target,
                                   float hand_reach) {
  const Box box = bounding_box(target.samples.positions);
  const Eigen::Vector3f centre = 0.5F * (box.min + box.max);
  const float reach = 0.5F * box.extent().norm() + hand_reach + greatest_distance;
  const TargetSpace space(target.samples);
  ReachableSamples near(centre, reach, space);
  for (std::size_t i = 0; i < around.objects.size(); ++i) {
    if (static_cast<int>(i) != target.object) near.add(around.objects[i]);
  }
  near.add(around.others);
  return near.samples();
}

}  // namespace

GraspJudge::GraspJudge(const GraspSurroundings& around, const GraspTarget& target,
                       const Gripper& gripper, const GraspOptions& options)
    : around_(around),
      target_(target),
      gripper_(gripper),
      options_(options),
      swept_(hand_shape(gripper, gripper.max_opening, gripper.approach_distance)),
      between_(space_between(gripper, gripper.max_opening)),
      finger_points_(sample_boxes(swept_.fingers(), hand_spacing)),
      palm_points_(sample_boxes(swept_.palm(), hand_spacing)),
      obstacles_(reachable_obstacles(around, target, reach_on_way(gripper, swept_))) {}

GraspJudge::Verdict GraspJudge::judge(const ApproachPose& pose, Search search) const {
  Verdict verdict;
  verdict.grasp.object = target_.object;
  verdict.grasp.T_world_tool = pose.T_world_tool;
  verdict.grasp.source = pose.source;
  verdict.grasp.features.tilt = angle_between(pose.T_world_tool.linear().col(2), -target_.up);
  if (pose.table_clearance < options_.bounds.table_clearance)  // before contacts are searched
    fail(verdict, GraspRejection::table, pose.table_clearance, options_.bounds.table_clearance);
  using Step = void (GraspJudge::*)(Verdict&, Search) const;
  constexpr std::array<Step, 4> steps{&GraspJudge::require_contact, &GraspJudge::require_clear_way,
                                      &GraspJudge::require_seen_space,
                                      &GraspJudge::require_clear_retreat};
  for (const Step step : steps) {
    if (verdict.reason) return verdict;
    (this->*step)(verdict, search);
  }
  if (verdict.reason) return verdict;
  verdict.grasp.quality = success_probability(verdict.grasp);
  if (verdict.grasp.quality < options_.bounds.min_quality)
    fail(verdict, GraspRejection::low_quality, verdict.grasp.quality, options_.bounds.min_quality);
  return verdict;
}

void GraspJudge::require_contact(Verdict& verdict, Search) const {
  Grasp& grasp = verdict.grasp;
  const auto contacts =
      find_contacts(target_.samples, grasp.T_world_tool, gripper_, options_.bounds.contact_give);
  if (!contacts)
    return fail(verdict, GraspRejection::no_contact, 0.0, options_.bounds.min_contact_area);
  grasp.opening = contacts->opening();
  const double shift = 0.5 * (contacts->positive.y + contacts->negative.y);
  judge_contacts(verdict, *contacts);
  if (!verdict.reason) judge_weight(verdict, *contacts);
  grasp.T_world_tool.translation() += shift * grasp.T_world_tool.linear().col(1);
}

void GraspJudge::judge_contacts(Verdict& verdict, const Contacts& contacts) const {
  const PadContact& a = contacts.positive;
  const PadContact& b = contacts.negative;
  GraspFeatures& features = verdict.grasp.features;
  const double cone = std::atan(gripper_.friction);
  const double angle = std::max(angle_between(a.normal, Eigen::Vector3d::UnitY()),
                                angle_between(b.normal, -Eigen::Vector3d::UnitY()));
  features.cone_margin = cone - angle;
  features.cone_share = std::min(a.cone_share, b.cone_share);
  features.contact_area =
      std::min(a.area, b.area) / (gripper_.finger_width * gripper_.finger_width);
  features.depth = std::min(a.depth, b.depth);
  features.observed = 0.5 * (a.observed + b.observed);
  const double narrower = gripper_.max_opening - verdict.grasp.opening;
  const double wider = verdict.grasp.opening - gripper_.min_opening;
  features.opening_margin = gripper_.min_opening > 0.0 ? std::min(narrower, wider) : narrower;
  const double along = std::abs(target_.seen_from.dot(verdict.grasp.T_world_tool.linear().col(1)));
  features.depth_tolerance = std::min(greatest_tolerance, 0.5 * narrower / std::max(along, 1e-6));
  const GraspBoundOptions& bounds = options_.bounds;
  if (narrower < bounds.opening_clearance) {
    fail(verdict, GraspRejection::too_wide, verdict.grasp.opening,
         gripper_.max_opening - bounds.opening_clearance);
  } else if (wider <= 0.0) {
    fail(verdict, GraspRejection::too_thin, verdict.grasp.opening, gripper_.min_opening);
  } else if (features.contact_area < bounds.min_contact_area) {
    fail(verdict, GraspRejection::no_contact, features.contact_area, bounds.min_contact_area);
  } else if (features.cone_margin < 0.0) {
    fail(verdict, GraspRejection::friction, angle, cone);
  }
}

void GraspJudge::judge_weight(Verdict& verdict, const Contacts& contacts) const {
  GraspFeatures& features = verdict.grasp.features;
  const Eigen::Vector3d closing = verdict.grasp.T_world_tool.linear().col(1);
  const Eigen::Vector3d arm =
      target_.solid.centre_of_mass - verdict.grasp.T_world_tool * contacts.middle();
  const Eigen::Vector3d torque = arm.cross(-target_.up);  // per weight
  features.lever_arm = torque.norm();
  // Two disks of half a finger's width under even pressure hold 2 (2/3) μ F r.
  const double held =
      4.0 / 3.0 * gripper_.friction * gripper_.force * (gripper_.finger_width / 2.0);
  const double weight = options_.bounds.density * target_.solid.volume * gravity;
  features.torque_ratio = weight * std::abs(torque.dot(closing)) / held;
  // What acts along the closing direction, the fingers carry without friction. Without a table the
  // direction of gravity is not known.
  const double along_pads =
      around_.scene.table ? weight * target_.up.cross(closing).norm() : weight;
  const double weight_ratio = along_pads / (2.0 * gripper_.friction * gripper_.force);
  if (weight_ratio > options_.bounds.max_weight_ratio)
    return fail(verdict, GraspRejection::weight, weight_ratio, options_.bounds.max_weight_ratio);
  if (features.torque_ratio > options_.bounds.max_torque_ratio)
    fail(verdict, GraspRejection::torque, features.torque_ratio, options_.bounds.max_torque_ratio);
}

float GraspJudge::distance_from(const SurfaceSamples& samples,
                                const Eigen::Isometry3d& T_world_tool,
                                std::span<const HandBox> boxes, double bound, Search search) const {
  const float enough = search == Search::complete ? -std::numeric_limits<float>::infinity()
                                                  : static_cast<float>(bound);
  return least_distance(samples, T_world_tool.inverse().cast<float>(), boxes,
                        {greatest_distance, enough});
}

double GraspJudge::height_on_way(const Eigen::Isometry3d& T_world_tool) const {
  if (!around_.scene.table) return greatest_distance;
  return std::min(height_over(*around_.scene.table, T_world_tool, swept_.boxes),
                  double{greatest_distance});
}

void GraspJudge::require_clear_way(Verdict& verdict, Search search) const {
  const GraspBoundOptions& bounds = options_.bounds;
  Grasp& grasp = verdict.grasp;
  const double height = height_on_way(grasp.T_world_tool);
  if (height < bounds.table_clearance)
    return fail(verdict, GraspRejection::table, height, bounds.table_clearance);
  const double others =
      distance_from(obstacles_, grasp.T_world_tool, swept_.boxes, bounds.object_clearance, search);
  if (others < bounds.object_clearance)
    return fail(verdict, GraspRejection::other_object, others, bounds.object_clearance);
  const double enclosed =
      distance_from(obstacles_, grasp.T_world_tool, {&between_, 1}, 0.0, search);
  if (enclosed < 0.0) return fail(verdict, GraspRejection::other_object, enclosed, 0.0);
  const double own = distance_from(target_.samples, grasp.T_world_tool, swept_.boxes,
                                   bounds.own_clearance, search);
  if (own < bounds.own_clearance)
    return fail(verdict, GraspRejection::own_shape, own, bounds.own_clearance);
  grasp.features.clearance = std::min(height, others);
  grasp.features.own_clearance = own;
}

double GraspJudge::unknown_share(const Eigen::Matrix3Xf& points,
                                 const Eigen::Isometry3f& T_world_tool) const {
  Eigen::Index blocked = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3f p = T_world_tool * Eigen::Vector3f(points.col(i));
    if (around_.unknown->blocks(p, target_.object)) ++blocked;
  }
  return static_cast<double>(blocked) / static_cast<double>(points.cols());
}

void GraspJudge::require_seen_space(Verdict& verdict, Search) const {
  if (!around_.unknown) return;
  const Eigen::Isometry3f T_world_tool = verdict.grasp.T_world_tool.cast<float>();
  const double share = std::max(unknown_share(finger_points_, T_world_tool),
                                unknown_share(palm_points_, T_world_tool));
  if (share > options_.bounds.max_unknown)
    fail(verdict, GraspRejection::never_seen, share, options_.bounds.max_unknown);
}

void GraspJudge::require_clear_of_others(Verdict& verdict, const Eigen::Isometry3d& T_world_tool,
                                         std::span<const HandBox> boxes, Search search) const {
  const double bound = options_.bounds.object_clearance;
  const double others = distance_from(obstacles_, T_world_tool, boxes, bound, search);
  if (others < bound) fail(verdict, GraspRejection::other_object, others, bound);
}

void GraspJudge::require_clear_retreat(Verdict& verdict, Search search) const {
  const double opening = verdict.grasp.opening, retreat = gripper_.retreat_distance;
  if (retreats_backwards(verdict.grasp.T_world_tool.linear().col(2), around_.scene.table)) {
    const HandShape swept = hand_shape(gripper_, opening, retreat);
    return require_clear_of_others(verdict, verdict.grasp.T_world_tool, swept.boxes, search);
  }
  const HandShape closed = hand_shape(gripper_, opening, 0.0);
  // A step is at most as long as a finger with its clearance is thick, so that it misses no sample.
  const double thickness = 0.5 * (gripper_.finger_thickness + gripper_.tip_thickness);
  const double thinnest = std::min(gripper_.finger_width, thickness);
  const double step = std::clamp(thinnest + 2.0 * options_.bounds.object_clearance, 0.001, 0.01);
  Eigen::Isometry3d pose = verdict.grasp.T_world_tool;
  for (double height = step; height < retreat + step && !verdict.reason; height += step) {
    pose.translation() =
        verdict.grasp.T_world_tool.translation() + std::min(height, retreat) * target_.up;
    require_clear_of_others(verdict, pose, closed.boxes, search);
  }
}

}  // namespace symscene
