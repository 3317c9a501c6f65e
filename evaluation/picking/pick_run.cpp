#include "symscene/picking/pick_run.hpp"

namespace symscene {

const char* to_string(AttemptEnd end) {
  switch (end) {
    case AttemptEnd::in_bin:
      return "in_bin";
    case AttemptEnd::nothing_between_fingers:
      return "nothing_between_fingers";
    case AttemptEnd::lost_at_lift:
      return "lost_at_lift";
    case AttemptEnd::dropped:
      return "dropped";
    case AttemptEnd::missed_bin:
      return "missed_bin";
    case AttemptEnd::diverged:
      return "diverged";
  }
  return "";
}

const char* description(AttemptEnd end) {
  switch (end) {
    case AttemptEnd::in_bin:
      return "in the bin";
    case AttemptEnd::nothing_between_fingers:
      return "nothing was between the fingers";
    case AttemptEnd::lost_at_lift:
      return "it was lost at the lift";
    case AttemptEnd::dropped:
      return "it was dropped on the way to the bin";
    case AttemptEnd::missed_bin:
      return "it fell beside the bin";
    case AttemptEnd::diverged:
      return "the physics diverged";
  }
  return "";
}

const char* to_string(PickRunEnd end) {
  switch (end) {
    case PickRunEnd::cleared:
      return "cleared";
    case PickRunEnd::nothing_found:
      return "nothing_found";
    case PickRunEnd::no_pick:
      return "no_pick";
    case PickRunEnd::looks:
      return "looks";
    case PickRunEnd::no_start:
      return "no_start";
    case PickRunEnd::no_view:
      return "no_view";
    case PickRunEnd::diverged:
      return "diverged";
  }
  return "";
}

const char* description(PickRunEnd end) {
  switch (end) {
    case PickRunEnd::cleared:
      return "the table is empty";
    case PickRunEnd::nothing_found:
      return "nothing was found on the table";
    case PickRunEnd::no_pick:
      return "no grasp is left that the arm can take";
    case PickRunEnd::looks:
      return "the looks are used up";
    case PickRunEnd::no_start:
      return "an arm cannot start";
    case PickRunEnd::no_view:
      return "the camera does not see the table";
    case PickRunEnd::diverged:
      return "the physics diverged";
  }
  return "";
}

}  // namespace symscene
