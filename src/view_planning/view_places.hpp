#pragma once

#include <vector>

#include "view_space.hpp"

namespace symscene {

/// A place that a view can show, and what that is worth.
struct ViewPlace {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< just off the surface, world frame [m]
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();    ///< zero: visible from all sides
  double worth = 0.0;                                  ///< weighted area [m²]
};

/// The places that views are compared by.
struct ViewPlaces {
  std::vector<ViewPlace> inferred, disputed, unknown;
  double inferred_area = 0.0;          ///< unweighted [m²]
  double object_area = 0.0;            ///< of the objects' surfaces [m²]
  double unknown_area = 0.0;           ///< of the border, unweighted [m²]
  std::vector<ObjectArea> areas = {};  ///< per object, if the result has surfaces
};

/// About `samples` places of each kind at most.
ViewPlaces view_places(const KnownScene& scene, const ViewSpace& space,
                       const NextViewOptions& options);

}  // namespace symscene
