#include "symscene/viewer/plan_page.hpp"

#include <algorithm>
#include <cmath>

#include "core/base64.hpp"
#include "encoding.hpp"
#include "page_filling.hpp"
#include "page_template.hpp"
#include "run_payload.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using nlohmann::json;

constexpr const char* plan_to_show = "the page of a plan";

/// The tool's y and z axes are the closing and the approach direction.
json grasp_json(const ShownGrasp& shown) {
  const Eigen::Isometry3d& tool = shown.grasp.T_world_tool;
  if (!tool.matrix().allFinite() || !std::isfinite(shown.grasp.opening))
    throw InputError(plan_to_show, "finite poses of grasps", "one that is not finite");
  return {{"number", shown.number},
          {"object", shown.grasp.object},
          {"quality", shown.grasp.quality},
          {"opening", shown.grasp.opening},
          {"state", to_string(shown.state)},
          {"reason", shown.reason},
          {"position", encode(tool.translation())},
          {"closing", encode(tool.linear().col(1))},
          {"approach", encode(tool.linear().col(2))}};
}

std::string encode_shares(const std::vector<float>& shares, std::size_t cells) {
  if (shares.size() != cells)
    throw InputError(plan_to_show, std::to_string(cells) + " shares, one per cell",
                     std::to_string(shares.size()));
  std::vector<std::uint8_t> bytes;
  for (const float share : shares)
    bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F))));
  return base64(bytes);
}

json reach_json(const std::optional<ShownReach>& reach) {
  if (!reach) return nullptr;
  const auto cells = static_cast<std::size_t>(reach->centers.rows());
  return {{"spacing", reach->spacing},
          {"height", reach->height},
          {"centers", encode_positions(reach->centers)},
          {"above", encode_shares(reach->from_above, cells)},
          {"side", encode_shares(reach->from_side, cells)}};
}

}  // namespace

const char* to_string(ShownGraspState state) {
  switch (state) {
    case ShownGraspState::chosen:
      return "chosen";
    case ShownGraspState::reached:
      return "reached";
    case ShownGraspState::not_reached:
      return "not_reached";
    case ShownGraspState::not_tried:
      return "not_tried";
  }
  return "";
}

std::string render_plan_page(const PlanRecording& plan, const std::string& title) {
  json payload = run_payload(plan.motion, title);
  json grasps = json::array();
  for (const ShownGrasp& grasp : plan.grasps) grasps.push_back(grasp_json(grasp));
  payload["plan"] = {{"grasps", std::move(grasps)},
                     {"finger_depth", plan.finger_depth},
                     {"reach", reach_json(plan.reach)}};
  return fill_page(run_template(), title, script_json(payload));
}

}  // namespace symscene
