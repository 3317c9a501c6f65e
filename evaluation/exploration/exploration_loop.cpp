#include "exploration_loop.hpp"

#include <fmt/format.h>

#include "clutter/sensed_scene.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene {
namespace {

/// What one view adds to an exploration.
class LoopStep {
 public:
  LoopStep(const ExplorationWorld& world, const ClutterMethodOptions& sensing,
           const ExplorationLoop& loop, int number)
      : world_(world), sensing_(sensing), loop_(loop), timer_(on_begin(number)) {}

  void look(std::vector<ClutterView>& views, ExplorationStep& step) {
    views.push_back(timer_.time("look", [&] { return world_.look(step.view); }));
    scene_ = timer_.time("fuse", [&] { return sensed_scene(views, sensing_); });
    timer_.time("segment", [&] {
      if (!scene_.cloud.empty()) result_ = segment_scene(scene_, sensing_.pipeline);
    });
    timer_.time("measure", [&] {
      step.observed = world_.truth().observed(scene_);
      step.completed = world_.truth().completed(scene_, result_);
      step.masks = world_.truth().masks(result_);
    });
  }

  /// The next view. After the last one views are ranked only for who wants to know what is left.
  void choose(ViewChooser& chooser, bool is_last) {
    if (is_last && !loop_.until_enough) return;
    const ExploredScene known{scene_, result_, world_.truth()};
    choice_ = timer_.time("choose", [&] { return chooser.next(known); });
    seconds_ = timer_.stages().back().seconds;
    if (!loop_.until_enough) return;
    expected_ = chooser.policy() == ExplorationPolicy::symmetry
                    ? choice_.views
                    : chooser.ranked(known, ViewPolicy::symmetry);
  }

  void report(const ClutterView& view, ExplorationStep& step) const {
    if (!loop_.observer) return;
    loop_.observer({view, scene_, result_, choice_.views, expected_, timer_.stages()}, step);
  }

  /// Why no view follows; none if one does.
  std::optional<ExplorationEnd> end(bool is_last) const {
    if (expected_.is_enough) return ExplorationEnd::enough;
    if (is_last) return ExplorationEnd::views;
    if (!choice_.candidate) return ExplorationEnd::no_view;
    return std::nullopt;
  }

  /// What is known of the view that was chosen, before it is taken.
  ExplorationStep next_step() const {
    ExplorationStep step;
    step.view = *choice_.candidate;
    step.decision_seconds = seconds_;
    if (!choice_.views.ranked.empty()) step.gain = choice_.views.ranked.front().gain;
    return step;
  }

 private:
  StageTimer::OnBegin on_begin(int number) const {
    return [this, number](const std::string& stage) {
      if (loop_.on_begin) loop_.on_begin(fmt::format("view {}: {}", number, stage));
    };
  }

  const ExplorationWorld& world_;
  const ClutterMethodOptions& sensing_;
  const ExplorationLoop& loop_;
  StageTimer timer_;
  Scene scene_;
  SegmentationResult result_;
  ViewChoice choice_;
  NextViews expected_;
  double seconds_ = 0.0;  ///< of the choice
};

}  // namespace

Exploration explore(const ExplorationWorld& world, ViewChooser& chooser,
                    const ClutterMethodOptions& sensing, const ExplorationLoop& loop) {
  Exploration exploration;
  exploration.policy = chooser.policy();
  std::vector<ClutterView> views;
  ExplorationStep step;
  step.view = first_view;
  for (int k = 1;; ++k) {
    LoopStep now(world, sensing, loop, k);
    chooser.visit(step.view);
    now.look(views, step);
    now.choose(chooser, k == loop.views);
    now.report(views.back(), step);
    exploration.steps.push_back(step);
    if (const auto end = now.end(k == loop.views)) {
      exploration.end = *end;
      return exploration;
    }
    step = now.next_step();
  }
}

}  // namespace symscene
