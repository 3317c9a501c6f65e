#pragma once

#include <nlohmann/json.hpp>

#include "symscene/viewer/page.hpp"

namespace symscene {

/// The gripper and the grasps as the page reads them; null without. Throws InputError unless there
/// is a summary for each of `objects` objects and every grasp is of one of them, with a finite
/// pose.
nlohmann::json grasp_payload(const std::optional<PageGrasps>& grasps, std::size_t objects);

}  // namespace symscene
