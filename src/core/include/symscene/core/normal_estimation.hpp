#pragma once

#include <functional>
#include <optional>

#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct NormalEstimationOptions {
  int neighbors = 16;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("neighbors", self.neighbors, "points", between(3, 256),
          "nearest neighbours that a tangent plane is fitted to (Hoppe et al. 1992)");
  }
  void validate() const { check_fields(*this); }
};

/// Votes on the orientation of a normal at `position` [m]: above 0 if `direction` points out of the
/// surface, below 0 if it points inwards.
using OutwardVote =
    std::function<double(const Eigen::Vector3f& position, const Eigen::Vector3f& direction)>;

/// Unit normals (N×3) of planes fitted to each point's neighbours; zero where these do not span a
/// plane. Orientations are propagated over a minimum spanning tree whose edges prefer parallel
/// planes (Hoppe et al. 1992); the sum of the votes then decides the orientation of each connected
/// piece. Throws InputError if a coordinate is not finite or an option is out of its range.
Points estimate_normals(const Points& points, const OutwardVote& outward,
                        const NormalEstimationOptions& options = {});

}  // namespace symscene
