#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/clutter/clutter_rounds.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/exploration/exploration_policy.hpp"
#include "symscene/simulation/settling.hpp"

// Scenes of the clutter benchmark, and tables of scanned objects, that are looked at one view after
// the other. The policies by which the next view is chosen are compared on the same scenes with the
// same noise.
namespace symscene {

struct ExplorationOptions {
  ClutterKind kind = ClutterKind::packed;  ///< of clutter
  int objects = 5;
  int views = 8;
  /// After so many views the best grasp of the least visible object is tried and undone; 0: never.
  int grasp_after = 3;
  double radius = 0.6;  ///< of the half sphere of candidate views [m]
  std::uint64_t seed = 0;
  DropOptions drop = default_drop();  ///< of scanned objects
  NextViewOptions next_view;
  ClutterMethodOptions sensing;
  ClutterNoiseOptions noise;
  GraspExecutionOptions execution;
  GraspWorldOptions physics;

  /// Over a disc that the camera sees whole from every candidate.
  static DropOptions default_drop();
  /// Throws InputError if a value is out of its range.
  void validate() const;
};

/// What is known after a view.
struct ExplorationStep {
  std::size_t view = 0;    ///< the candidate that was looked from
  double observed = 0.0;   ///< share of the true surfaces within 5 mm of a point that was seen
  double completed = 0.0;  ///< the same, of points and closed surfaces of objects
  DetectionCounts masks;   ///< at an overlap of 0.75
  DetectionCounts axes;    ///< rotational symmetries within 10° and 1 cm
  DetectionCounts planes;  ///< reflectional symmetries within 10° and 1 cm
  std::optional<bool> grasped = {};  ///< whether the best grasp of the least visible object held it
  double decision_seconds = 0.0;     ///< of the choice of this view; 0 for the first
  std::optional<ViewGain> gain = {};  ///< expected of it; none of the first or an unranked one
};

/// Why no further view was taken.
enum class ExplorationEnd : std::uint8_t {
  views,   ///< as many as were asked for
  enough,  ///< no view is expected to show much more
  no_view  ///< all candidates were visited
};
/// The name of the enumerator with "-" for "_".
const char* to_string(ExplorationEnd end);

/// Exploration::kind of tables of scanned objects.
inline constexpr const char* scanned_table_kind = "table";

/// One scene, explored by one policy.
struct Exploration {
  std::string kind = {};  ///< of the scene: "packed", "pile" or "table"
  int scene = 0;          ///< its number among those of its kind
  ExplorationPolicy policy = ExplorationPolicy::symmetry;
  std::vector<ExplorationStep> steps;
  ExplorationEnd end = ExplorationEnd::views;
};

/// Explores scene number `scene` by each of the policies: the same objects, the same first view (60
/// degrees from the vertical at a random azimuth) and, at the same pose, the same noise. The same
/// options give the same explorations apart from times. Throws InputError if an option is out of
/// its range or this build has no physics, and PhysicsDiverged.
std::vector<Exploration> explore_clutter(std::span<const ClutterObject> objects,
                                         std::span<const ExplorationPolicy> policies,
                                         const ExplorationOptions& options, int scene);

/// The same of table number `scene`: models that were dropped onto it. Throws InputError if an
/// option is out of its range, no model can be used or this build has no physics, and
/// PhysicsDiverged.
std::vector<Exploration> explore_scanned_table(std::span<const ObjectModel> models,
                                               std::span<const ExplorationPolicy> policies,
                                               const ExplorationOptions& options, int scene);

}  // namespace symscene
