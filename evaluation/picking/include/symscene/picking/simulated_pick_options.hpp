#pragma once

#include <cstdint>
#include <string>

#include "symscene/clutter/clutter_methods.hpp"
#include "symscene/grasping/grasp_options.hpp"
#include "symscene/motion/pick.hpp"
#include "symscene/physics/arm_world.hpp"
#include "symscene/picking/camera_look_options.hpp"
#include "symscene/pipeline/pipeline_options.hpp"
#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/simulation/sensor_noise.hpp"
#include "symscene/tabletop/scene_building.hpp"
#include "symscene/view_planning/next_view_options.hpp"

namespace symscene {

/// How the motions are executed.
struct PickExecutionOptions {
  double control_period = 0.01;
  double closing_time = 0.6;
  double release_time = 0.8;
  double min_width = 0.003;
  double rest_time = 2.0;
  double bin_width = 0.26;
  double bin_height = 0.12;
  double drop_height = 0.03;
  double carry_acceleration = 2.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("control_period", self.control_period, "s", between(0.001, 0.1),
          "time between two targets of the joints, and between two looks at the contacts");
    visit("closing_time", self.closing_time, "s", above_up_to(0.0, 60.0),
          "time in which the fingers close");
    visit("release_time", self.release_time, "s", above_up_to(0.0, 60.0),
          "time in which the fingers open and the object falls");
    visit("min_width", self.min_width, "m", between(0.0, 1.0),
          "a hand that is closed to this width holds nothing");
    visit("rest_time", self.rest_time, "s", above_up_to(0.0, 60.0),
          "longest time that objects are given to come to rest before a look");
    visit("bin_width", self.bin_width, "m", between(0.05, 2.0), "inner edge of the square bin");
    visit("bin_height", self.bin_height, "m", between(0.01, 1.0), "height of its walls");
    visit("drop_height", self.drop_height, "m", between(0.0, 1.0),
          "height of the held object above the bin when the hand opens");
    visit("carry_acceleration", self.carry_acceleration, "m/s^2", above_up_to(0.0, 100.0),
          "greatest acceleration of the middle of an object that is carried to the bin: the "
          "fingers hold its weight and this");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// From where the camera looks.
enum class LookViews : std::uint8_t {
  sweep,  ///< images along a motion past the table, always the same
  next    ///< images from single views, each chosen by what is known after the one before
};
/// Throws InputError if no choice of views has that name.
LookViews parse_look_views(const std::string& name);

struct SimulatedPickOptions {
  int max_looks = 30;
  int max_failures = 2;
  int max_object_failures = 4;
  int empty_looks = 2;
  double crowded_lift_slack = 0.008;
  double record_rate = 20.0;
  std::uint64_t seed = 1;
  CameraLookOptions look;
  SensorNoiseOptions sensor = default_sensor();
  NextViewOptions next_view = default_next_view();
  ReconstructionOptions reconstruction;
  SceneBuildingOptions scene;
  PipelineOptions pipeline;
  GraspOptions grasping;
  PickOptions pick = default_pick();
  PickExecutionOptions execution;
  ArmWorldOptions physics;
  GraspMethod method = GraspMethod::symscene;  ///< symscene or cylinders
  LookViews views = LookViews::sweep;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_looks", self.max_looks, "", between(1, 10000), "looks after which the run ends");
    visit("max_failures", self.max_failures, "", at_least(1),
          "failed attempts at a place after which no grasp is tried there again");
    visit("max_object_failures", self.max_object_failures, "", at_least(1),
          "failed attempts on an object, wherever on it, after which it is given up");
    visit("empty_looks", self.empty_looks, "", at_least(1),
          "looks in a row without a grasp that the arm can take, after which the run ends");
    visit("crowded_lift_slack", self.crowded_lift_slack, "m", above_up_to(0.0, 0.05),
          "pick.collision.lift_slack where no object can be taken otherwise");
    visit("record_rate", self.record_rate, "1/s", between(1.0, 100.0),
          "recorded moments per simulated second");
    visit("seed", self.seed, "", any_value(), "seed of the sensor's noise");
    visit("look", self.look);
    visit("sensor", self.sensor);
    visit("next_view", self.next_view);
    visit("reconstruction", self.reconstruction);
    visit("scene", self.scene);
    visit("pipeline", self.pipeline);
    visit("grasping", self.grasping);
    visit("pick", self.pick);
    visit("execution", self.execution);
    visit("physics", self.physics);
  }
  /// A camera of short range, which does not see the floor behind the table.
  static SensorNoiseOptions default_sensor();
  /// The range of that camera.
  static NextViewOptions default_next_view();
  /// All grasps of a table are tried before a look counts as empty.
  static PickOptions default_pick();
  /// Throws InputError if a value is out of its range or the method needs true meshes.
  void validate() const;
};

}  // namespace symscene
