#pragma once

#include <functional>
#include <vector>

#include "exploration_world.hpp"
#include "symscene/core/stage_timer.hpp"
#include "symscene/exploration/exploration.hpp"
#include "view_chooser.hpp"

namespace symscene {

/// A view that was taken, and what is known after it.
struct ExplorationLook {
  const ClutterView& view;
  const Scene& scene;                ///< of all views so far, fused
  const SegmentationResult& result;  ///< of that scene
  const NextViews& next;             ///< what the policy ranks for the next view
  const NextViews& expected;  ///< the same by symmetry; empty unless the loop is until_enough
  const std::vector<StageTime>& timings;
};

/// How long views are taken, and who is told about them.
struct ExplorationLoop {
  int views = 8;
  /// Ends where no view is expected to show much more, and ranks views after the last one too.
  bool until_enough = false;
  /// Called after each view; it may add to the step.
  std::function<void(const ExplorationLook&, ExplorationStep&)> observer = {};
  StageTimer::OnBegin on_begin = {};  ///< of each stage of each view
};

/// Looks from the first view, fuses all views so far, segments, chooses the next view, and so on.
/// Nothing depends on the times.
Exploration explore(const ExplorationWorld& world, ViewChooser& chooser,
                    const ClutterMethodOptions& sensing, const ExplorationLoop& loop);

}  // namespace symscene
