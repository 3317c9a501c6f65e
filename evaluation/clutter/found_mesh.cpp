#include "clutter/found_mesh.hpp"

#include <algorithm>
#include <vector>

namespace symscene {

Index found_mesh(const Points& points, const TrueSurface& surface, std::size_t meshes) {
  constexpr double reach = 0.02;  // of an observed point from its object's true surface [m]
  std::vector<std::size_t> counts(meshes);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d point = points.row(i).transpose().cast<double>();
    const Index mesh = surface.nearest(point, reach).mesh;
    if (mesh != TrueSurface::Nearest::nothing) ++counts[mesh];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  if (most == counts.end() || *most == 0) return TrueSurface::Nearest::nothing;
  return static_cast<Index>(most - counts.begin());
}

}  // namespace symscene
