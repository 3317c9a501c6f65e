#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "symscene/core/stage_timer.hpp"
#include "symscene/exploration/exploration.hpp"
#include "symscene/simulation/tabletop.hpp"

// A simulated table that a camera explores until no view is expected to show much more.
namespace symscene {

struct TableExplorationOptions {
  ClutterKind kind = ClutterKind::packed;
  ExplorationPolicy policy = ExplorationPolicy::symmetry;
  int objects = 5;
  int views = 10;
  double spread = 0.12;
  double radius = 0.7;
  std::uint64_t seed = 1;
  NextViewOptions choice;
  ClutterNoiseOptions noise;
  PipelineOptions pipeline;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("objects", self.objects, "", between(1, 20), "objects on the table");
    visit("views", self.views, "", between(1, 34), "views after which it ends at the latest");
    visit("spread", self.spread, "m", between(0.0, 0.25),
          "radius of the disc over which objects are dropped");
    visit("radius", self.radius, "m", between(0.3, 1.5),
          "of the half sphere of candidates about the middle of the table");
    visit("seed", self.seed, "", any_value(), "seed of objects, places, first view and noise");
    visit("choice", self.choice);
    visit("noise", self.noise);
    visit("pipeline", self.pipeline);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Whether furnish_exploration() needs physics: meshes are dropped, and piles are.
bool needs_physics(const TableExplorationOptions& options, bool has_models);

/// Objects on the table of the clutter benchmark, in its world frame. Packed: household objects
/// side by side, or `models` dropped upright, if there are any. Pile: any of them, dropped in any
/// orientation. Throws InputError if an option is out of range, no model can be used, or physics is
/// needed and this build has none.
Tabletop furnish_exploration(std::span<const ObjectModel> models,
                             const TableExplorationOptions& options);

/// A view that was taken, and what is known after it. World frame.
struct ExploredView {
  ExplorationStep step;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  std::vector<float> depth;          ///< what the camera measured, 0 where nothing; row by row [m]
  std::vector<SceneObject> objects;  ///< that are known; points refer to no cloud that is kept
  std::vector<ObjectSurface> surfaces;  ///< per object
  NextViews next;                       ///< what the policy ranks after it; empty if it ranks none
  NextViews expected;                   ///< the same by symmetry
  std::vector<StageTime> timings;
};

/// What came of an exploration.
struct TableExploration {
  ExplorationPolicy policy = ExplorationPolicy::symmetry;
  CameraIntrinsics camera;
  std::vector<Eigen::Isometry3d> candidates;  ///< T_world_camera
  std::vector<ExploredView> views;            ///< at least one
  ExplorationEnd end = ExplorationEnd::views;
  Scene scene;                ///< of all views, fused
  SegmentationResult result;  ///< of that scene
  std::vector<double> seen;   ///< per object of the table: the share of its surface that was seen

  /// By symmetry, after the last view: what is left to see.
  const NextViews& left() const { return views.back().expected; }
};

/// Who is told about an exploration while it runs.
struct ExplorationObserver {
  StageTimer::OnBegin on_begin = {};                      ///< of each stage of each view
  std::function<void(const ExploredView&)> on_view = {};  ///< after each view
};

/// Looks, fuses, segments and chooses the next view until no view is expected to show much more (by
/// symmetry, whatever the policy), or as many views were taken as the options allow. The first view
/// is one from 60 degrees from the vertical at a random azimuth. The same options give the same
/// result apart from times. Throws InputError if an option is out of range.
TableExploration explore_table(const Tabletop& table, const TableExplorationOptions& options,
                               const ExplorationObserver& observer = {});

}  // namespace symscene
