#include "pick_choice.hpp"

#include <algorithm>
#include <span>

namespace symscene {
namespace {

std::vector<BeliefFate> fates_of(const TableBelief& belief) {
  std::vector<BeliefFate> fates;
  for (const ObjectGraspSummary& object : belief.objects)
    fates.push_back({object.grasps, 0, 0, {}, object.reason});
  return fates;
}

Box box_of(const GraspObject& object) {
  const TriangleMesh& mesh = object.surface.mesh;
  return bounding_box(mesh.vertices.rows() > 0 ? mesh.vertices : object.observed.positions);
}

/// The grasps that are not given up: those of objects with the fewest failed attempts first, and
/// among these the best first.
std::vector<Grasp> grasps_to_try(const PickScene& in, const TableBelief& belief,
                                 const FailedAttempts& failed, std::vector<BeliefFate>& fates) {
  for (std::size_t k = 0; k < fates.size(); ++k)
    fates[k].failures = failed.in(box_of(belief.scene.objects[k]));
  const auto fate = [&](const Grasp& grasp) -> BeliefFate& {
    return fates[static_cast<std::size_t>(grasp.object)];
  };
  std::vector<Grasp> grasps;
  for (const Grasp& grasp : belief.grasps) {
    if (fate(grasp).failures < in.options.max_object_failures &&
        failed.at(tip_point(grasp, in.gripper)) < in.options.max_failures)
      grasps.push_back(grasp);
    else
      ++fate(grasp).given_up;
  }
  std::stable_sort(grasps.begin(), grasps.end(), [&](const Grasp& a, const Grasp& b) {
    return fate(a).failures < fate(b).failures;
  });
  return grasps;
}

std::string nothing_left(const TableBelief& belief) {
  if (belief.scene.objects.empty()) return "nothing was found on the table";
  if (belief.grasps.empty()) return "no object has a grasp";
  return "the arm can take no grasp";
}

/// Among objects that stand close a lifted one may push its neighbours aside.
SimulatedPickOptions crowded(SimulatedPickOptions options) {
  options.pick.collision.lift_slack = options.crowded_lift_slack;
  return options;
}

PickChoice choose_pick_with(const PickScene& in, const TableBelief& belief,
                            const Eigen::VectorXd& start, const FailedAttempts& failed,
                            StageTimer& timer) {
  constexpr int most_places = 8;  // grasps without a way to the bin before the choice is given up
  PickChoice choice{std::nullopt, fates_of(belief), {}};
  const std::vector<Grasp> grasps = grasps_to_try(in, belief, failed, choice.fates);
  const auto reject = [&](const Grasp& grasp, RejectedPick why) {
    choice.fates[static_cast<std::size_t>(grasp.object)].rejected.push_back(std::move(why));
  };
  std::span<const Grasp> rest(grasps);
  for (int tries = 0; tries < most_places && !rest.empty(); ++tries) {
    PickResult result = timer.time("motion to the grasp", [&] {
      return plan_pick(in.robot, in.arm, in.gripper, start, in.scene, rest, in.options.pick);
    });
    for (const RejectedPick& why : result.rejected) reject(rest[why.grasp], why);
    if (!result.start_contact.empty()) {
      choice.no_pick = "the arm cannot start: " + result.start_contact;
      return choice;
    }
    if (!result.motion) break;
    const Grasp& grasp = rest[result.motion->grasp];
    PlaceMotion place = timer.time("motion to the bin",
                                   [&] { return plan_place(in, start, *result.motion, grasp); });
    if (place.path) {
      choice.planned = PlannedPick{grasp, std::move(*result.motion), std::move(*place.path)};
      return choice;
    }
    reject(grasp, {0, PickRejection::no_path, "with the object to the bin: " + place.obstacle});
    rest = rest.subspan(result.motion->grasp + 1);
  }
  choice.no_pick = nothing_left(belief);
  return choice;
}

}  // namespace

Eigen::Vector3d tip_point(const Grasp& grasp, const Gripper& gripper) {
  return grasp.T_world_tool * Eigen::Vector3d(0.0, 0.0, gripper.finger_depth);
}

PickChoice choose_pick(const PickScene& in, const TableBelief& belief, const Eigen::VectorXd& start,
                       const FailedAttempts& failed, StageTimer& timer) {
  PickChoice choice = choose_pick_with(in, belief, start, failed, timer);
  if (choice.planned || belief.grasps.empty()) return choice;
  const SimulatedPickOptions options = crowded(in.options);
  const PickScene pushing{in.robot, in.arm, in.gripper, in.scene, in.bin, options};
  PickChoice second = choose_pick_with(pushing, belief, start, failed, timer);
  return second.planned ? second : choice;
}

}  // namespace symscene
