#include "view_payload.hpp"

#include <cmath>

#include "scan_payload.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using nlohmann::json;

void require_finite(const PageView& view) {
  const double sum = view.gain + view.inferred + view.disputed + view.unknown + view.cost;
  if (!view.T_world_camera.matrix().allFinite() || !std::isfinite(sum))
    throw InputError("the page", "finite poses and gains of views", "one that is not finite");
}

json to_json(const PageView& view) {
  require_finite(view);
  return {{"candidate", view.candidate},
          {"camera", camera_payload(view.T_world_camera)},
          {"gain", view.gain},
          {"inferred", view.inferred},
          {"disputed", view.disputed},
          {"unknown", view.unknown},
          {"cost", view.cost}};
}

}  // namespace

json view_payload(const std::optional<PageViews>& views) {
  if (!views) return nullptr;
  if (!(views->half_width > 0.0) || !(views->half_height > 0.0) ||
      !std::isfinite(views->half_width + views->half_height))
    throw InputError("the page", "an image of positive size", "another");
  json list = json::array();
  for (const PageView& view : views->views) list.push_back(to_json(view));
  return {{"policy", views->policy},
          {"unit", views->unit},
          {"half_size", {views->half_width, views->half_height}},
          {"is_enough", views->is_enough},
          {"list", std::move(list)}};
}

}  // namespace symscene
