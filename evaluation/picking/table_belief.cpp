#include "table_belief.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cylinder_belief.hpp"
#include "symscene/core/object_class.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene {
namespace {

std::string label_of(const SceneObject& object) {
  const std::string kind =
      object.symmetry_class ? to_string(object.symmetry_class->kind) : "object";
  return fmt::format("{}, {:.2f}", kind, object.rank());
}

}  // namespace

TablePerception::TablePerception(const SimulatedPickOptions& options)
    : options_(options), reconstruction_(options.look.intrinsics(), options.reconstruction) {}

void TablePerception::add(const DepthFrame& frame, const Eigen::Isometry3d& by_arm,
                          const Eigen::Isometry3d& truth) {
  // The first image places the scene; from then on the arm tells about where the camera is.
  const PoseUse use = reconstruction_.empty() ? PoseUse::exact : PoseUse::prior;
  const FrameReport report =
      timer_.time("tracking and fusion", [&] { return reconstruction_.add(frame, by_arm, use); });
  ++frames_;
  perceived_.reset();
  const auto measured = [](float depth) { return depth > 0.0F; };
  if (!report.fused || std::none_of(frame.depth.begin(), frame.depth.end(), measured)) return;
  estimated_.push_back(report.tracking.T_world_camera);
  truth_.push_back(truth);
}

Scene TablePerception::build() {
  if (reconstruction_.empty()) return {};
  const TriangleMesh surface = timer_.time("surface", [&] { return reconstruction_.surface(); });
  if (surface.vertices.rows() == 0) return {};
  // The robot knows where up is, and where its camera was.
  TablePrior prior;
  prior.up = Eigen::Vector3d::UnitZ();
  for (const Eigen::Isometry3d& pose : estimated_) prior.viewpoints.push_back(pose.translation());
  Scene scene = timer_.time("table", [&] {
    return build_scene({surface.vertices, surface.normals, surface.colors},
                       reconstruction_.occupancy(), prior, options_.scene)
        .scene;
  });
  // Without a table, what was seen is not what stands on it.
  return scene.table ? scene : Scene{};
}

const PerceivedScene& TablePerception::perceived() {
  if (perceived_) return *perceived_;
  perceived_.emplace(PerceivedScene{build(), {}});
  PerceivedScene& now = *perceived_;
  if (!now.scene.cloud.empty())
    now.result =
        timer_.time("objects", [&] { return segment_scene(now.scene, options_.pipeline); });
  return now;
}

TableBelief TablePerception::finish(const Gripper& gripper) {
  TableBelief belief;
  if (options_.method == GraspMethod::cylinders) {
    const Scene scene = perceived_ ? perceived_->scene : build();
    return scene.cloud.empty() ? belief : cylinder_belief(scene, gripper, timer_);
  }
  const PerceivedScene& now = perceived();
  if (now.scene.cloud.empty()) return belief;
  GraspPlan plan = timer_.time("grasps", [&] {
    belief.scene = grasp_scene(now.result, &now.scene, options_.grasping);
    return plan_grasps(belief.scene, gripper, options_.grasping);
  });
  for (const SceneObject& object : now.result.objects) belief.labels.push_back(label_of(object));
  belief.grasps = std::move(plan.grasps);
  belief.objects = std::move(plan.objects);
  return belief;
}

PickLook TablePerception::look() const {
  PickLook look;
  look.frames = frames_;
  look.fused = estimated_.size();
  if (!estimated_.empty()) look.trajectory = trajectory_error(estimated_, truth_);
  for (const StageTime& time : timer_.stages()) add_to_sums(look.times, time);
  return look;
}

}  // namespace symscene
