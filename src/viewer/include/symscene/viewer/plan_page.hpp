#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "symscene/core/grasp.hpp"
#include "symscene/viewer/run_page.hpp"

namespace symscene {

/// What became of a grasp when motions were planned.
enum class ShownGraspState : std::uint8_t {
  chosen,       ///< the motion takes it
  reached,      ///< the arm reaches it too
  not_reached,  ///< for a reason
  not_tried
};
/// The name of the enumerator.
const char* to_string(ShownGraspState state);

/// A grasp on the page of a plan.
struct ShownGrasp {
  std::size_t number = 0;  ///< among all grasps that were proposed
  Grasp grasp;             ///< pose in the frame of the table
  ShownGraspState state = ShownGraspState::not_tried;
  std::string reason;  ///< why it is not reached
};

/// Which share of directions an arm reaches the cells of a table from.
struct ShownReach {
  double spacing = 0.0;           ///< edge of a square cell [m]
  double height = 0.0;            ///< of the finger tips above the table [m]
  Points centers;                 ///< of the cells, in the frame of the table [m]
  std::vector<float> from_above;  ///< per cell: of closing directions, approach straight down
  std::vector<float> from_side;   ///< per cell: of approach directions, horizontal
};

/// A planned motion and what it was chosen from.
struct PlanRecording {
  RunRecording motion;  ///< without beliefs; one moment if there is no motion
  std::vector<ShownGrasp> grasps;
  double finger_depth = 0.0;  ///< how far fingers reach beyond the tool frame [m]
  std::optional<ShownReach> reach;
};

/// A self-contained HTML page that plays the motion, lists for every grasp whether it is reached
/// and why not, and colours the table by the share of directions from which the arm reaches it.
/// Throws InputError as render_run_page() does, and if a grasp or a cell is not finite, or shares
/// are not one per cell.
std::string render_plan_page(const PlanRecording& plan, const std::string& title);

}  // namespace symscene
