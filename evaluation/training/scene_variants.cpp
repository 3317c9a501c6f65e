#include "scene_variants.hpp"

#include <cmath>

#include "core/random.hpp"
#include "core/rigid_motion.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/options.hpp"

namespace symscene::bench {
namespace {

constexpr double max_shift = 0.01;  // [m], two cells of the sampling grid

Eigen::Isometry3d random_motion(std::uint64_t seed) {
  Random random(seed, 77);
  const auto normals = [&] {
    return Eigen::Vector4d(random.normal(), random.normal(), random.normal(), random.normal());
  };
  const Eigen::Vector4d q = normals().normalized();
  Eigen::Isometry3d motion(Eigen::Quaterniond(q[0], q[1], q[2], q[3]));
  motion.pretranslate(Eigen::Vector3d(random.uniform(), random.uniform(), random.uniform()) *
                      max_shift);
  return motion;
}

void move(const Eigen::Isometry3d& motion, Scene& scene, SceneTruth& truth) {
  scene.cloud = transformed(std::move(scene.cloud), motion);
  if (scene.table) scene.table = transformed(*scene.table, motion);
  truth.table = transformed(truth.table, motion);
  // Axes and planes of the ground truth are not moved: samples of objects use its masks alone.
}

}  // namespace

std::vector<std::string> scene_variants() { return {"as-is", "posed", "noisy"}; }

void vary(const std::string& variant, std::uint64_t seed, Scene& scene, SceneTruth& truth) {
  if (variant == "posed") {
    move(random_motion(seed), scene, truth);
    scene.occupancy.reset();
  } else if (variant == "noisy") {
    Random random(seed, 78);
    scene.cloud = with_noise(std::move(scene.cloud), random.uniform(2.0, 6.0), seed);
  }
}

PointCloud with_noise(PointCloud cloud, double degrees, std::uint64_t seed) {
  constexpr double cell = 0.01;               // [m]
  constexpr double offset_per_degree = 1e-4;  // [m]
  const auto sigma = static_cast<float>(radians(degrees));
  if (sigma > 0.0F && !cloud.has_normals())
    throw InputError("--noise", "clouds with normals", "one without");
  for (Index i = 0; i < cloud.size() && sigma > 0.0F; ++i) {
    const Eigen::Vector3d at = (cloud.position(i).cast<double>() / cell).array().floor();
    const auto key = static_cast<std::uint64_t>((at.x() * 73856093.0) + (at.y() * 19349663.0) +
                                                (at.z() * 83492791.0) + 1e12);
    Random shared(key, seed), own(i, seed + 1);
    const auto turn = [&](Random& random) {
      return Eigen::Vector3f(static_cast<float>(random.normal()),
                             static_cast<float>(random.normal()),
                             static_cast<float>(random.normal()));
    };
    const Eigen::Vector3f n =
        (cloud.normal(i) + sigma * (turn(shared) + 0.5F * turn(own))).normalized();
    const auto off = static_cast<float>(degrees * offset_per_degree * shared.normal());
    cloud.positions.row(i) += off * cloud.normals.row(i);
    cloud.normals.row(i) = n.transpose();
  }
  return cloud;
}

}  // namespace symscene::bench
