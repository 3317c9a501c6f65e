#pragma once

#include <span>
#include <string>
#include <vector>

#include "symscene/view_planning/next_view.hpp"
#include "symscene/viewer/page.hpp"

namespace symscene::app {

/// Views of a camera, ranked.
struct RankedCandidates {
  const CameraIntrinsics& camera;
  std::span<const Eigen::Isometry3d> poses;  ///< T_world_camera of the candidates
  const NextViews& views;
  ViewPolicy policy = ViewPolicy::symmetry;
};

/// The text of the file that `symscene next-view` writes (docs/formats.md). Equal views give equal
/// bytes apart from the times.
std::string format_next_views_json(const RankedCandidates& ranked);

/// A table of the best views for people, and whether they are worth it.
std::string format_next_views(const RankedCandidates& ranked);

/// The views as the page draws them.
PageViews page_views(const RankedCandidates& ranked);

}  // namespace symscene::app
