#include <iostream>

#include <symscene/core/geometry.hpp>
#include <symscene/core/neighbors.hpp>

int main() {
  const symscene::ReflectionPlane mirror{{0.1, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  const Eigen::Vector3d image = mirror.reflect_point({0.3, 0.2, 0.1});
  const symscene::Points points = symscene::Points::Random(100, 3);
  const symscene::NeighborLists neighbors = symscene::nearest_neighbors(points, 5);
  std::cout << image.transpose() << ", " << neighbors.of(0).size() << " neighbours\n";
  return image.isApprox(Eigen::Vector3d(-0.1, 0.2, 0.1)) && neighbors.of(0).size() == 5 ? 0 : 1;
}
