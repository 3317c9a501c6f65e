#pragma once

#include "recorded_run.hpp"
#include "symscene/viewer/exploration_page.hpp"

namespace symscene {

/// A box that is looked at twice; only the second view shows it.
inline ExplorationRecording explored_box() {
  ExplorationRecording exploration;
  RunRecording& run = exploration.run;
  run.solids = {{"sugar", standing_box(0.05F, 0.08F, 0.17F), RecordedKind::object},
                {"table", standing_box(0.7F, 0.7F, 0.001F), RecordedKind::table},
                {"camera", standing_box(0.04F, 0.04F, 0.04F), RecordedKind::hand}};
  run.times = {0.0, 2.0};
  for (const double x : {-0.5, 0.5})
    run.poses.push_back({placed_at(0, 0, 0), placed_at(0, 0, -0.001), placed_at(x, 0.1, 0.4)});
  run.beliefs = {{0.0, {}}, {2.0, {{"object 0", run.solids[0].mesh, "box 0, 0.93"}}}};
  run.events = {{0.0, "view 1"}, {2.0, "view 2"}};
  run.left = {"25 % is left"};
  const PageView first{3, placed_at(-0.5, 0.1, 0.4), 0.0, 0.0, 0.0, 0.0, 0.0};
  const PageView second{7, placed_at(0.5, 0.1, 0.4), 12.5, 10.0, 0.5, 2.0, 0.0};
  PageViews next;
  next.policy = "symmetry";
  next.views = {second};
  const ShownDepth depth{2, 2, {0, 1, 128, 255}};
  exploration.views = {{0.0, first, 0.25, 0.5, 0, next, depth},
                       {2.0, second, 0.75, 0.875, 1, PageViews{"symmetry"}, depth}};
  exploration.end = "all candidate views were taken";
  return exploration;
}

}  // namespace symscene
