#pragma once

#include "core/twist.hpp"
#include "reconstruction/pose_fit.hpp"
#include "reconstruction/projective_association.hpp"

namespace symscene {

/// Bounds and weights of the matches of one pyramid level.
struct MatchOptions {
  double max_distance = 0.0;   ///< between matched points [m]
  double max_angle = 0.0;      ///< between matched normals [rad]
  double robust_sigmas = 0.0;  ///< residual at which Cauchy's weight is one half [deviations]
  DepthNoise noise;
};

/// Point-to-plane normal equations of the twist (ω, t), in the fixed camera's frame, that moves the
/// moved image: H ξ = b with H = Σ w J Jᵀ, b = Σ w r J, J = (p × n, n), r = n · (q − p) (Newcombe
/// et al. 2011, Eqs. 20 to 24). Weights are relative to a match at 1 m.
struct NormalEquations {
  Matrix6d H = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  double weight = 0.0;  ///< sum of the weights of all matches
  PoseFit fit;
};

/// Matches the pixels of `moved` with those of `fixed` by projection and weights them by the noise
/// of their depth and by Cauchy's function. Both images must outlive it. The same bits for any
/// number of threads.
class PointToPlaneMatcher {
 public:
  PointToPlaneMatcher(const SurfaceImage& moved, const SurfaceImage& fixed,
                      const MatchOptions& options);

  /// The normal equations with the normals n of the fixed image.
  NormalEquations match(const Eigen::Isometry3d& T_fixed_moved) const;

  /// The same with ½ (n mᵀ + m nᵀ) in place of n nᵀ in H, where m is the normal of the moved image,
  /// and b = 0. The noise of n and m is independent, so it averages out in H instead of adding
  /// constraints that the surface does not have.
  NormalEquations match_constraints(const Eigen::Isometry3d& T_fixed_moved) const;

  /// The weight of a match at 1 m without residual. [1/m²]
  double unit_weight() const;

 private:
  struct Sums;
  struct Batch;
  template <bool constraints>
  NormalEquations sum_rows(const Eigen::Isometry3f& T_fixed_moved) const;
  template <bool constraints>
  void add_row(std::size_t v, const Eigen::Isometry3f& T_fixed_moved, Sums& sums) const;
  template <bool constraints>
  bool add_match(const ProjectivePair& pair, const Eigen::Isometry3f& T_fixed_moved, Batch& batch,
                 Sums& sums) const;

  ProjectiveAssociation association_;
  DepthNoise noise_;
  float squared_distance_;
  float min_cosine_;
  float robust_sigmas_;
};

}  // namespace symscene
