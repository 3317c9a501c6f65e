#include "symscene/grasping/planner.hpp"

#include <algorithm>
#include <memory>

#include "core/parallel.hpp"
#include "object_planner.hpp"
#include "surface_checks.hpp"

namespace symscene {
namespace {

GraspSurroundings surroundings(const GraspScene& scene, const GraspOptions& options) {
  GraspSurroundings around{
      scene, {}, surface_samples(scene.obstacles), std::nullopt, Eigen::Vector3d::Zero()};
  around.objects.resize(scene.objects.size());
  parallel_for_each(around.objects.size(), [&](std::size_t i) {
    around.objects[i] = surface_samples(scene.objects[i].surface);
  });
  around.seen_from = mean_seen_normal(around.objects);
  if (scene.space) {
    around.unknown.emplace(*scene.space, around.objects, around.others,
                           static_cast<float>(options.bounds.own_reach));
  }
  return around;
}

/// Why no candidate of the object is worth a look.
std::optional<GraspRejection> reason_against(const GraspSurroundings& around, std::size_t id) {
  if (around.objects[id].size() == 0) return GraspRejection::no_surface;
  if (around.unknown && around.unknown->is_outside(around.objects[id]))
    return GraspRejection::outside_space;
  return std::nullopt;
}

/// Consecutive lines of one object.
struct LineBlock {
  std::size_t object;
  std::size_t begin;
  std::size_t end;
};

/// Plans the grasps of all objects. Lines are judged in fixed blocks, as objects differ in the time
/// that they take.
class ScenePlanner {
 public:
  ScenePlanner(const GraspSurroundings& around, const Gripper& gripper, const GraspOptions& options)
      : planners_(around.objects.size()), plans_(around.objects.size()) {
    parallel_for_each(planners_.size(), [&](std::size_t i) {
      std::optional<GraspRejection>& reason = plans_[i].summary.reason;
      reason = reason_against(around, i);
      if (reason) return;
      const GraspTarget target = grasp_target(around.scene, i, around.objects[i], around.seen_from);
      if (target.solid.volume > 0.0)
        planners_[i] = std::make_unique<ObjectPlanner>(around, target, gripper, options);
      else
        reason = GraspRejection::no_surface;
    });
  }

  std::vector<ObjectPlan> plans() {
    const std::vector<LineBlock> blocks = line_blocks();
    std::vector<JudgedLines> judged(blocks.size());
    parallel_for_each(blocks.size(), [&](std::size_t b) {
      judged[b] = planners_[blocks[b].object]->judge(blocks[b].begin, blocks[b].end);
    });
    parallel_for_each(plans_.size(), [&](std::size_t i) {
      if (!planners_[i]) return;
      const auto first_from = [&](std::size_t object) {
        return std::partition_point(blocks.begin(), blocks.end(),
                                    [&](const LineBlock& block) { return block.object < object; }) -
               blocks.begin();
      };
      const auto begin = static_cast<std::size_t>(first_from(i));
      const auto end = static_cast<std::size_t>(first_from(i + 1));
      plans_[i] = planners_[i]->plan(std::span(judged).subspan(begin, end - begin));
    });
    return std::move(plans_);
  }

 private:
  std::vector<LineBlock> line_blocks() const {
    constexpr std::size_t length = 16;
    std::vector<LineBlock> blocks;
    for (std::size_t i = 0; i < planners_.size(); ++i) {
      const std::size_t lines = planners_[i] ? planners_[i]->lines() : 0;
      for (std::size_t begin = 0; begin < lines; begin += length)
        blocks.push_back({i, begin, std::min(begin + length, lines)});
    }
    return blocks;
  }

  std::vector<std::unique_ptr<ObjectPlanner>> planners_;  ///< none: no candidate is worth a look
  std::vector<ObjectPlan> plans_;
};

}  // namespace

GraspPlan plan_grasps(const GraspScene& scene, const Gripper& gripper,
                      const GraspOptions& options) {
  gripper.validate();
  options.validate();
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    require_moderate_size(scene.objects[i].surface, i);
  StageTimer timer;
  const GraspSurroundings around =
      timer.time("surroundings", [&] { return surroundings(scene, options); });
  const std::vector<ObjectPlan> objects =
      timer.time("candidates", [&] { return ScenePlanner(around, gripper, options).plans(); });
  GraspPlan plan = timer.time("ranking", [&] { return joined(objects); });
  plan.timings = timer.stages();
  return plan;
}

}  // namespace symscene
