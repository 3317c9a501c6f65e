#pragma once

#include <functional>
#include <optional>

#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct NormalEstimationOptions {
  int neighbors = 16;  ///< nearest points that a tangent plane is fitted to

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("neighbors", self.neighbors, "points",
          "nearest points that a tangent plane is fitted to");
  }
  /// Throws InputError unless 3 <= neighbors <= 256.
  void validate() const;
};

/// How well `direction` points out of the surface at `position`: above 0 for outwards, below 0 for
/// inwards.
using OutwardVote =
    std::function<double(const Eigen::Vector3f& position, const Eigen::Vector3f& direction)>;

/// Unit normals (N×3) from the tangent planes of each point's neighbours; zero where these do not
/// span a plane. Signs are made to agree along the surface (Hoppe et al. 1992: over a minimum
/// spanning tree whose edges prefer parallel planes), then each connected piece is turned as the
/// sum of its votes says. Throws InputError if a coordinate is not finite.
Points estimate_normals(const Points& points, const OutwardVote& outward,
                        const NormalEstimationOptions& options = {});

}  // namespace symscene
