#pragma once

#include <span>
#include <vector>

#include "symscene/core/camera.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/view_planning/next_view_options.hpp"

namespace symscene {

/// What a view is chosen by.
enum class ViewPolicy : std::uint8_t {
  symmetry,         ///< what symmetries infer and leave open (outlook of the thesis, section 4.7)
  unknown_voxels,   ///< number of never seen voxels on the rays (Isler et al., ICRA 2016)
  rear_side_voxels  ///< of those, the ones right behind which an occupied voxel lies (the same)
};
/// The name of the enumerator.
const char* to_string(ViewPolicy policy);
/// Throws InputError if no policy has that name.
ViewPolicy view_policy(std::string_view name);

/// What is known of a scene. World frame.
struct KnownScene {
  const SegmentationResult& result;
  const OccupancyMap* occupancy = nullptr;  ///< none: no space counts as free or never seen
};

/// The expected gain of a view and its parts. [m²], or voxels for the policies that count them.
struct ViewGain {
  double inferred = 0.0;  ///< inferred surface that it would see, weighted
  double disputed = 0.0;  ///< surface on which hypotheses disagree, weighted
  double unknown = 0.0;   ///< border of never seen space, weighted; or voxels
  double cost = 0.0;      ///< weighted
  double total() const { return inferred + disputed + unknown - cost; }
};

struct RankedView {
  std::size_t candidate = 0;
  ViewGain gain;
};

/// Of the surface of an object, without what rests on the table. [m²]
struct ObjectArea {
  double inferred = 0.0;  ///< not seen yet
  double all = 0.0;
};

struct NextViews {
  std::vector<RankedView> ranked;  ///< by descending gain
  /// No view is worth it: the best gain is below min_share, or there is none to rank.
  bool is_enough = false;
  std::size_t unreachable = 0;         ///< candidates of infinite cost
  double inferred_area = 0.0;          ///< of the objects' surfaces, not seen yet [m²]
  double object_area = 0.0;            ///< of the objects' surfaces [m²]
  double unknown_area = 0.0;           ///< of the border between free and never seen space [m²]
  std::vector<ObjectArea> areas = {};  ///< per object; empty if the result has no surfaces
  std::vector<StageTime> timings;
};

/// Ranks candidate views of a camera (T_world_camera). `costs`: one per candidate, or none; a view
/// of infinite cost cannot be reached and is left out. Views with equal gains stay in their order.
/// Throws InputError on invalid options, if the costs are not as many as the candidates, a
/// candidate is not finite or more than 1 km from the scene, the result has neither none nor one
/// surface and completion per object, or a policy counts voxels and there is no occupancy.
NextViews rank_views(const KnownScene& scene, const CameraIntrinsics& camera,
                     std::span<const Eigen::Isometry3d> candidates,
                     const NextViewOptions& options = {}, ViewPolicy policy = ViewPolicy::symmetry,
                     std::span<const double> costs = {});

}  // namespace symscene
