#pragma once

#include <optional>
#include <span>

#include "symscene/dataset/scene_variation.hpp"
#include "symscene/dataset/split.hpp"
#include "symscene/dataset/swept_scene.hpp"

namespace symscene {

/// Number and kind of the scenes of a simulated dataset, modelled on the Cluttered Tabletop
/// Dataset.
struct DatasetOptions {
  int scenes = 89;
  std::uint64_t seed = 1;
  int min_objects = 1;
  int max_objects = 15;
  int arranged_every = 4;
  double scanned = 0.5;
  double min_scale = 1.0;
  double max_scale = 1.0;
  double min_spread = 0.02;
  double max_spread = 0.055;
  double max_stacked = 0.5;
  double max_touching = 0.8;
  int attempts = 20;
  int patience = 4;
  double max_lost = 0.1;
  double max_error = 0.01;
  double max_table_error = 0.01;
  CameraArcOptions camera = {.frames = 150, .radius = 0.8};
  HandShakeOptions shake;
  SensorNoiseOptions sensor;
  double frame_rate = 30.0;
  SweptSceneOptions making;
  SceneVariationOptions variation;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("scenes", self.scenes, "", between(1, 10000),
          "number of scenes, by default that of the Cluttered Tabletop Dataset");
    visit("seed", self.seed, "", any_value(), "seed of all scenes");
    visit("min_objects", self.min_objects, "", between(1, 20), "fewest objects of a scene");
    visit("max_objects", self.max_objects, "", between(1, 20), "most objects of a scene");
    visit("arranged_every", self.arranged_every, "", at_least(0),
          "interval of scenes whose objects are arranged, not dropped; 0 for never");
    visit("scanned", self.scanned, "", between(0.0, 1.0),
          "share of scanned models among the dropped objects, if there are any");
    visit("min_scale", self.min_scale, "", between(0.2, 2.0),
          "least scale of dropped household objects, drawn uniformly in its logarithm");
    visit("max_scale", self.max_scale, "", between(0.2, 2.0),
          "greatest scale of dropped household objects");
    visit("min_spread", self.min_spread, "m", between(0.0, 0.08),
          "least radius over which objects drop, per square root of their number");
    visit("max_spread", self.max_spread, "m", between(0.0, 0.08),
          "greatest radius over which objects drop, per square root of their number");
    visit("max_stacked", self.max_stacked, "", between(0.0, 1.0),
          "largest share of arranged objects that are tried on top of another");
    visit("max_touching", self.max_touching, "", between(0.0, 1.0),
          "largest share of arranged objects that are pushed up against another");
    visit("attempts", self.attempts, "", at_least(1),
          "seeds that are tried until one makes an accurate scene");
    visit("patience", self.patience, "", at_least(1),
          "failed seeds of a scene after which every further seed has one more object");
    visit("max_lost", self.max_lost, "", between(0.0, 1.0),
          "largest share of the frames of an accurate scene that tracking loses");
    visit("max_error", self.max_error, "m", above(0.0),
          "largest root mean square error of the camera positions of an accurate scene");
    visit("max_table_error", self.max_table_error, "m", above(0.0),
          "largest error of the height of the table under the objects of an accurate scene");
    visit("camera", self.camera);
    visit("shake", self.shake);
    visit("sensor", self.sensor);
    visit("frame_rate", self.frame_rate, "1/s", above(0.0), "frames per second");
    visit("making", self.making);
    visit("variation", self.variation);
  }
  /// Throws InputError if a value is out of its range or a maximum is below its minimum.
  void validate() const;
};

/// A seed whose scene was not accurate enough, and why.
struct FailedAttempt {
  std::uint64_t seed = 0;
  std::string reason;
};

/// How a scene was made.
struct SceneFacts {
  std::size_t index = 0;
  Split split = Split::test;
  std::uint64_t seed = 0;
  bool dropped = false;               ///< by physics; otherwise arranged
  std::size_t objects_asked = 0;      ///< number of objects to place
  std::size_t objects_placed = 0;     ///< number that found a place to rest
  std::size_t objects_seen = 0;       ///< number in the ground truth
  std::size_t frames = 0;             ///< of the sweep
  std::size_t fused = 0;              ///< of the frames
  double path_error = 0.0;            ///< of the poses of fused frames, root mean square [m]
  std::vector<FailedAttempt> failed;  ///< seeds tried before this one, or all
  bool good = false;                  ///< whether the scene is accurate enough
  std::optional<ScenePlan> plan;      ///< what was drawn, where scenes vary
};

/// A scene of a dataset: that of the first accurate attempt, otherwise of the last one.
struct MadeScene {
  Scene scene;
  SceneTruth truth;
  SceneFacts facts;
  std::vector<StageTime> stages;      ///< wall time of all attempts
  std::vector<std::string> warnings;  ///< of all attempts, one sentence each
};

/// The objects of a scene on their table, in a randomly rotated and shifted world. If `drop` is
/// set, procedural objects and a share of `options.scanned` of `models` are dropped over a disc of
/// random radius; otherwise procedural objects are arranged with random shares of stacked and
/// touching ones. Throws InputError if objects are dropped and this build has no physics.
Tabletop place_objects(const DatasetOptions& options, std::span<const ObjectModel> models,
                       int objects, std::uint64_t seed, bool drop);

/// Makes scene `index` of a dataset: puts objects on a table, sweeps a noisy camera around it,
/// reconstructs the sweep by tracking and transfers the ground truth to the reconstruction.
/// `models` are those of the split (models_of()); procedural objects stand among them. If the
/// reconstruction is not accurate enough or the physics diverges, the scene is made again with its
/// next seed. The result depends on the arguments only: not on other scenes, nor on the number of
/// threads. Throws InputError if an option is out of range, or if there are models and this build
/// has no physics; PhysicsDiverged if the physics of the last seed diverges.
MadeScene make_scene(const DatasetOptions& options, Split split,
                     std::span<const ObjectModel> models, std::size_t index);

/// The models that can be dropped: solids that are thick enough to be seen.
std::vector<ObjectModel> droppable(std::vector<ObjectModel> models);

}  // namespace symscene
