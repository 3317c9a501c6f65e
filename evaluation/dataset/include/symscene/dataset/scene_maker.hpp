#pragma once

#include <span>

#include "symscene/dataset/split.hpp"
#include "symscene/dataset/swept_scene.hpp"

namespace symscene {

/// How a simulated dataset is made, after the Cluttered Tabletop Dataset: its number of scenes, and
/// what they are like.
struct DatasetOptions {
  int scenes = 89;           ///< as many as the Cluttered Tabletop Dataset has
  std::uint64_t seed = 1;    ///< of all scenes
  int min_objects = 1;       ///< in a scene
  int max_objects = 15;      ///< in a scene
  int arranged_every = 4;    ///< every so many scenes objects are put in place; 0: all are dropped
  double scanned = 0.5;      ///< share of scanned models among dropped objects, where there are any
  double min_scale = 1.0;    ///< size of dropped household objects by that of real ones
  double max_scale = 1.0;    ///< drawn between these, evenly by its logarithm
  double min_spread = 0.02;  ///< radius that objects drop over, times the root of their number [m]
  double max_spread = 0.055;  ///< the same where things lie loosest [m]
  double max_stacked = 0.5;   ///< largest share of arranged objects that try to stand on another
  double max_touching = 0.8;  ///< largest share of arranged objects pushed up against another
  int attempts = 20;          ///< seeds that are tried for a scene until one makes a good one
  double max_lost = 0.1;      ///< share of the frames that tracking may lose
  double max_error = 0.01;    ///< of the camera's path, root mean square [m]
  double max_table_error = 0.01;  ///< of the table's height under the objects [m]
  CameraArcOptions camera = {.frames = 150, .radius = 0.8};
  HandShakeOptions shake;
  SensorNoiseOptions sensor;
  double frame_rate = 30.0;  ///< [1/s]
  SweptSceneOptions making;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("scenes", self.scenes, "", "how many scenes");
    visit("seed", self.seed, "", "seed of all scenes");
    visit("min_objects", self.min_objects, "", "fewest objects of a scene, 1 to 15");
    visit("max_objects", self.max_objects, "", "most objects of a scene, 1 to 15");
    visit("arranged_every", self.arranged_every, "",
          "every so many scenes objects are put in place, not dropped; 0 for never");
    visit("scanned", self.scanned, "", "share of scanned models among the dropped objects");
    visit("min_scale", self.min_scale, "", "least size of dropped household objects by real ones");
    visit("max_scale", self.max_scale, "", "greatest such size");
    visit("min_spread", self.min_spread, "m",
          "least radius that objects drop over, times the root of their number");
    visit("max_spread", self.max_spread, "m", "largest such radius");
    visit("max_stacked", self.max_stacked, "", "largest share of arranged objects on others");
    visit("max_touching", self.max_touching, "", "largest share of arranged objects that touch");
    visit("attempts", self.attempts, "", "seeds that are tried for a scene");
    visit("max_lost", self.max_lost, "", "share of the frames that tracking may lose");
    visit("max_error", self.max_error, "m", "error of the camera's path, root mean square");
    visit("max_table_error", self.max_table_error, "m", "error of the table under the objects");
    visit("camera", self.camera);
    visit("shake", self.shake);
    visit("sensor", self.sensor);
    visit("frame_rate", self.frame_rate, "1/s", "frames a second");
    visit("making", self.making);
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// A seed that did not make a scene, and why.
struct FailedAttempt {
  std::uint64_t seed = 0;
  std::string reason;
};

/// How a scene came about.
struct SceneFacts {
  std::size_t index = 0;
  Split split = Split::test;
  std::uint64_t seed = 0;
  bool dropped = false;               ///< by physics; arranged else
  std::size_t objects_asked = 0;      ///< of the scene
  std::size_t objects_placed = 0;     ///< those that found a place to rest
  std::size_t objects_seen = 0;       ///< those of the truth
  std::size_t frames = 0;             ///< of the sweep
  std::size_t fused = 0;              ///< of the frames
  double path_error = 0.0;            ///< of the fused frames' poses, root mean square [m]
  std::vector<FailedAttempt> failed;  ///< before this seed, or all if no seed was good
  bool good = false;                  ///< whether the scene is one
};

/// A scene of a dataset. Not good, it is what the last attempt made.
struct MadeScene {
  Scene scene;
  SceneTruth truth;
  SceneFacts facts;
  std::vector<StageTime> stages;  ///< wall time of all attempts
};

/// The objects of a scene on their table, in a world turned at random. Dropped are procedural
/// objects, and with `models` about the share of these that `options` ask for, over a disc that
/// makes them lie tight or loose; arranged are procedural ones alone, stacked and touching as often
/// as the seed says. Throws InputError if objects are dropped and this build has no physics.
Tabletop place_objects(const DatasetOptions& options, std::span<const ObjectModel> models,
                       int objects, std::uint64_t seed, bool drop);

/// Makes scene `index` of a dataset: puts objects on a table, sweeps a noisy camera around it,
/// reconstructs that by tracking and carries the truth over. `models` are those of the split
/// (models_of()); procedural objects stand among them. A seed whose reconstruction is not good
/// enough gives way to the scene's next one, and after four there is an object more with every
/// seed. Depends on nothing but its arguments: not on other
/// scenes, nor on the number of threads. Throws InputError where an option is out of its range, or
/// there are models and this build has no physics.
MadeScene make_scene(const DatasetOptions& options, Split split,
                     std::span<const ObjectModel> models, std::size_t index);

/// The models that can be dropped: solids thick enough to be seen.
std::vector<ObjectModel> droppable(std::vector<ObjectModel> models);

}  // namespace symscene
