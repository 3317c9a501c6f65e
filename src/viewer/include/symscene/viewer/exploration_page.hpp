#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symscene/viewer/page.hpp"
#include "symscene/viewer/run_page.hpp"
#include "symscene/viewer/shown_depth.hpp"

namespace symscene {

/// A view of an exploration, and what is known after it.
struct ShownView {
  double time = 0.0;        ///< of the recording, when it is taken [s]
  PageView view;            ///< with the gain that it was chosen for
  double observed = 0.0;    ///< share of the true surfaces that was seen
  double completed = 0.0;   ///< share that was seen or is inferred
  std::size_t objects = 0;  ///< that are known
  PageViews next;           ///< what could follow; empty if the policy ranks nothing
  ShownDepth depth;
};

/// A scene that was looked at one view after the other.
struct ExplorationRecording {
  RunRecording run;  ///< the camera is its solid of kind hand; `left`: what is left unknown
  std::vector<ShownView> views;  ///< with times that never fall
  std::string end;               ///< why no further view was taken
};

/// A self-contained HTML page that plays the exploration: the true scene beside the objects that
/// are known after each view, the views that were taken and those that could follow, depth images,
/// and how much is known by view. Throws InputError as render_run_page() does, and if there is no
/// view, a number is not finite, times fall, or a depth image has not one value per pixel.
std::string render_exploration_page(const ExplorationRecording& exploration,
                                    const std::string& title);

}  // namespace symscene
