#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "symscene/clutter/clutter_views.hpp"
#include "symscene/core/grasp.hpp"
#include "symscene/grasping/grasp_options.hpp"
#include "symscene/pipeline/pipeline_options.hpp"
#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/tabletop/view_scene.hpp"

namespace symscene {

/// Which grasps are tried.
enum class GraspMethod {
  symscene,     ///< grasps of segmented objects
  cylinders,    ///< bounding cylinders of Euclidean clusters (section 4.6.3)
  true_meshes,  ///< the same planner on the true meshes: the most that segmentation can gain
  antipodal,    ///< random antipodal grasps on the true meshes
  random        ///< random poses at the true meshes
};

/// The name of a method in options: "true-meshes" for true_meshes.
const char* to_string(GraspMethod method);

/// The method of that name. Throws InputError for any other text.
GraspMethod parse_grasp_method(const std::string& text);

/// How a method is told about the table.
enum class TableKnowledge {
  none,   ///< it is searched
  plane,  ///< its plane is given, as it is to the published methods
  scale   ///< moreover, depths of each image are scaled so that it shows the table there
};

/// The name of the enumerator.
const char* to_string(TableKnowledge knowledge);

/// What is known of that name. Throws InputError for any other text.
TableKnowledge parse_table_knowledge(const std::string& text);

struct ClutterMethodOptions {
  TableKnowledge table = TableKnowledge::scale;
  ViewSceneOptions view;                 ///< of one view
  ReconstructionOptions reconstruction;  ///< of several views
  PipelineOptions pipeline;
  GraspOptions grasping;
  bool in_volume_only = true;  ///< leave out grasps whose position is outside the grasp volume
};

/// The grasps that a method proposes.
struct GraspProposals {
  std::vector<Grasp> grasps;         ///< best first
  std::size_t outside = 0;           ///< left out as their position is outside the grasp volume
  std::vector<std::string> reasons;  ///< why objects have no grasp, one per such object
  std::size_t objects = 0;           ///< that the method sees
  double seconds = 0.0;              ///< wall time from depth images to grasps
  double grasping_seconds = 0.0;     ///< of these for the grasps of segmented objects
};

/// Proposes grasps. The methods on true meshes see the world itself, the others its views.
GraspProposals propose_grasps(GraspMethod method, const ClutterWorld& world,
                              std::span<const ClutterView> views,
                              const ClutterMethodOptions& options, std::uint64_t seed);

}  // namespace symscene
