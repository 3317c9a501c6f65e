#include "object_normals.hpp"

#include "symscene/core/error.hpp"

namespace symscene {

PointCloud oriented_surface(PointCloud cloud, const Eigen::Vector3f& center,
                            const NormalEstimationOptions& options) {
  const auto outward = [&](const Eigen::Vector3f& at, const Eigen::Vector3f& direction) {
    return double{direction.dot(at - center)};
  };
  if (oriented_points(cloud).empty())
    cloud.normals = estimate_normals(cloud.positions, outward, options);
  cloud = select(cloud, oriented_points(cloud));
  if (cloud.empty()) throw InputError("object", "a surface with normals", "points that span none");
  return cloud;
}

}  // namespace symscene
