#include "symscene/viewer/exploration_page.hpp"

#include <cmath>
#include <limits>

#include "core/base64.hpp"
#include "page_filling.hpp"
#include "page_template.hpp"
#include "run_payload.hpp"
#include "symscene/core/error.hpp"
#include "view_payload.hpp"

namespace symscene {
namespace {

using nlohmann::json;

constexpr const char* exploration_to_show = "the page of an exploration";

void require_views(const std::vector<ShownView>& views) {
  if (views.empty()) throw InputError(exploration_to_show, "at least one view", "none");
  double last = -std::numeric_limits<double>::infinity();
  for (const ShownView& view : views) {
    if (!std::isfinite(view.time + view.observed + view.completed) || view.time < last)
      throw InputError(exploration_to_show, "finite numbers and times that never fall", "others");
    last = view.time;
  }
}

json depth_json(const ShownDepth& depth) {
  if (depth.nearness.size() != depth.width * depth.height)
    throw InputError(exploration_to_show, "one value of depth per pixel", "another number");
  return {{"width", depth.width}, {"height", depth.height}, {"data", base64(depth.nearness)}};
}

/// `view` as one of a list, so that the page draws both in the same way.
json taken_json(const ShownView& shown) {
  PageViews one = shown.next;
  one.views = {shown.view};
  return view_payload(one).at("list").at(0);
}

json shown_json(const ShownView& shown) {
  return {{"time", shown.time},
          {"view", taken_json(shown)},
          {"observed", shown.observed},
          {"completed", shown.completed},
          {"objects", shown.objects},
          {"next", view_payload(shown.next)},
          {"depth", depth_json(shown.depth)}};
}

}  // namespace

std::string render_exploration_page(const ExplorationRecording& exploration,
                                    const std::string& title) {
  require_views(exploration.views);
  json payload = run_payload(exploration.run, title);
  json views = json::array();
  for (const ShownView& shown : exploration.views) views.push_back(shown_json(shown));
  payload["exploration"] = {{"views", std::move(views)}, {"end", exploration.end}};
  return fill_page(run_template(), title, script_json(payload));
}

}  // namespace symscene
