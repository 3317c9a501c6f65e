#include "symscene/picking/simulated_pick_options.hpp"

#include "symscene/clutter/table_grasps.hpp"

namespace symscene {

SensorNoiseOptions SimulatedPickOptions::default_sensor() {
  SensorNoiseOptions sensor;
  sensor.max_depth = 1.0;
  return sensor;
}

PickOptions SimulatedPickOptions::default_pick() {
  PickOptions options;
  options.max_grasps = 400;
  return options;
}

void SimulatedPickOptions::validate() const {
  check_fields(*this);
  require_sensed_method(method);
}

}  // namespace symscene
