#include "exploration_world.hpp"

#include <utility>

#include "clutter/view_rendering.hpp"
#include "core/random.hpp"

namespace symscene {

Eigen::Vector3d exploration_target() { return {0.5 * clutter::size, 0.5 * clutter::size, 0.10}; }

std::vector<Eigen::Isometry3d> exploration_candidates(double radius, double first_azimuth) {
  return views_on_sphere(exploration_target(), Eigen::Vector3d::UnitZ(), radius, default_view_rings,
                         first_azimuth);
}

ExplorationWorld::ExplorationWorld(const std::vector<TriangleMesh>& objects,
                                   std::vector<Eigen::Isometry3d> candidates,
                                   const ClutterNoiseOptions& noise, std::uint64_t noise_seed)
    : candidates_(std::move(candidates)),
      noise_(noise),
      noise_seed_(noise_seed),
      renderer_(table_renderer(objects)),
      truth_(objects) {}

ClutterView ExplorationWorld::look(std::size_t candidate) const {
  return noisy_view(renderer_, candidates_[candidate], noise_, Random(noise_seed_, candidate));
}

}  // namespace symscene
