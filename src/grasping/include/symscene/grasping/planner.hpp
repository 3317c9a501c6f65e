#pragma once

#include <optional>
#include <vector>

#include "symscene/core/grasp.hpp"
#include "symscene/core/gripper.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/grasping/grasp_options.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"

namespace symscene {

/// An object to grasp. World frame.
struct GraspObject {
  PointCloud observed;    ///< its observed points, with normals
  ObjectSurface surface;  ///< closed, with its observed faces; empty: the object gets no grasp
  std::vector<ObjectAxis> axes = {};
  std::vector<ObjectPlane> planes = {};
  std::optional<ObjectClass> symmetry_class = {};
  std::optional<SolidProperties> solid = {};  ///< computed from the surface if there is none
};

/// What the planner knows of a scene. World frame.
struct GraspScene {
  std::vector<GraspObject> objects;
  std::optional<Plane> table;  ///< unit normal that points up; none: +z is up, nothing is below
  /// Other points that the gripper must not touch, for instance those of no object. [m]
  Points obstacles = {};
  /// Never-seen and occupied space counts as an obstacle; none: all space off the objects is free.
  std::optional<OccupancyGrid> space = {};
};

/// Grasps of every object, judged on its completed shape. Apart from the times, the result has the
/// same bits for any number of threads. Throws InputError if the gripper or an option is invalid,
/// or a surface has more than 25 m².
GraspPlan plan_grasps(const GraspScene& scene, const Gripper& gripper,
                      const GraspOptions& options = {});

/// The scene of a result with its objects' points, closed surfaces and symmetries. `scene` is that
/// from which the result was made; without one, or without occupancy, no space is never seen.
/// Throws InputError if a surface has more than 25 m².
GraspScene grasp_scene(const SegmentationResult& result, const Scene* scene = nullptr,
                       const GraspOptions& options = {});

}  // namespace symscene
