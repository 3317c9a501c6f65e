#include "reconstruction/pose_fit.hpp"

#include "reconstruction/projective_association.hpp"

namespace symscene {

PoseFit& PoseFit::operator+=(const PoseFit& other) {
  points += other.points;
  shown += other.shown;
  matches += other.matches;
  inliers += other.inliers;
  squares += other.squares;
  return *this;
}

PoseFit depth_fit(const SurfaceImage& moved, const SurfaceImage& fixed,
                  const Eigen::Isometry3d& T_fixed_moved, const DepthNoise& noise) {
  const ProjectiveAssociation association(moved, fixed);
  const Eigen::Isometry3f T = T_fixed_moved.cast<float>();
  PoseFit fit;
  for (std::size_t v = 0; v < association.rows(); ++v) {
    fit.points +=
        static_cast<double>(association.for_each_pair(v, T, [&](const ProjectivePair& pair) {
          const float behind = pair.moved_point.z() - pair.fixed.depth;
          const float bound = inlier_sigmas * noise.deviation(pair.moved.depth, pair.fixed.depth);
          if (behind > bound) return;
          fit.shown += 1.0;
          if (behind < -bound) return;
          fit.matches += 1.0;
          fit.inliers += 1.0;
          fit.squares += static_cast<double>(behind) * static_cast<double>(behind);
        }));
  }
  return fit;
}

}  // namespace symscene
