#include "io/view_json.hpp"

namespace symscene {

Json camera_json(const CameraIntrinsics& camera) {
  return {{"width", camera.width}, {"height", camera.height}, {"fx", camera.fx},
          {"fy", camera.fy},       {"cx", camera.cx},         {"cy", camera.cy}};
}

Json stage_times_json(std::span<const StageTime> times) {
  Json list = Json::array();
  for (const StageTime& time : times)
    list.push_back({{"stage", time.stage}, {"seconds", time.seconds}});
  return list;
}

}  // namespace symscene
