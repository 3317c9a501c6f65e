#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/grasp.hpp"
#include "symscene/core/gripper.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"
#include "symscene/viewer/shown_depth.hpp"

namespace symscene {

/// Grasps of the objects of a result, and the gripper that they are for.
struct PageGrasps {
  Gripper gripper;
  GraspPlan plan;
};

/// A view that a camera could take.
struct PageView {
  std::size_t candidate = 0;  ///< its number among the candidates
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  double gain = 0.0;  ///< what it is expected to show, and its parts [unit of PageViews]
  double inferred = 0.0;
  double disputed = 0.0;
  double unknown = 0.0;
  double cost = 0.0;
};

/// Views by descending gain, and the camera that would take them.
struct PageViews {
  std::string policy;         ///< by which they were ranked
  std::string unit = "cm²";   ///< of gains
  double half_width = 0.55;   ///< of the image at unit depth
  double half_height = 0.42;  ///< of the image at unit depth
  bool is_enough = false;     ///< no view is expected to show much more
  std::vector<PageView> views = {};
};

/// An object of the ground truth.
struct PageTruth {
  std::string name;
  PointIndices points;  ///< into the result's cloud, ascending; empty where it has none of them
};

/// A frame of the camera's sweep.
struct PageFrame {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  ShownDepth depth;
};

struct PageOptions {
  // Every field has an initialiser, so that callers may name only some without a warning.
  std::string title = "Segmentation";
  std::string note = {};                             ///< line under the title
  std::string noun = "object";                       ///< what the page calls an object
  std::optional<Plane> table = std::nullopt;         ///< its normal is up; the grid lies on it
  std::optional<Eigen::Vector3d> up = std::nullopt;  ///< without a table; default: the world's z
  TriangleMesh surface = {};   ///< reconstructed surface; page_surface() of it is shown
  Trajectory trajectory = {};  ///< path of the camera
  std::optional<PageGrasps> grasps = std::nullopt;
  std::optional<PageViews> views = std::nullopt;
  std::vector<PageTruth> truth = {};  ///< to compare the objects with
  std::vector<PageFrame> sweep = {};  ///< frames that the page plays, in order

  void validate() const;  // throws InputError
};

/// A self-contained HTML page that shows the result; it needs no other file and no network. Titles
/// and notes are escaped. Throws InputError if a position is not finite, an index is not below the
/// size of the cloud, `completed` or `surfaces` are neither empty nor one per object, the cloud
/// does not lie on the surface, grasps are not those of the result's objects, a pose or a gain is
/// not finite, or a depth image has not one value per pixel.
std::string render_page(const SegmentationResult& result, const PageOptions& options = {});

}  // namespace symscene
