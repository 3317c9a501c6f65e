#include "symscene/picking/simulated_pick_options.hpp"

#include "symscene/clutter/table_grasps.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

LookViews parse_look_views(const std::string& name) {
  if (name == "sweep") return LookViews::sweep;
  if (name == "next") return LookViews::next;
  throw InputError("views", "sweep or next", name);
}

SensorNoiseOptions SimulatedPickOptions::default_sensor() {
  SensorNoiseOptions sensor;
  sensor.max_depth = 1.0;
  return sensor;
}

NextViewOptions SimulatedPickOptions::default_next_view() {
  NextViewOptions options;
  options.max_depth = default_sensor().max_depth;
  return options;
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
