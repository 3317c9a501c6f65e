#pragma once

#include <functional>
#include <vector>

#include "core/random.hpp"
#include "core/surface_sampling.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene::testing {

/// Builds a cloud from noisy surfaces.
class CloudBuilder {
 public:
  explicit CloudBuilder(std::uint64_t seed, double noise = 0.0015) : random_(seed), noise_(noise) {}

  /// A rectangle of points 4 mm apart, its middle at `middle`.
  void add_rectangle(const Eigen::Vector3d& middle, const Eigen::Vector3d& along,
                     const Eigen::Vector3d& across) {
    const Eigen::Vector3d normal = along.cross(across).normalized();
    const auto count = static_cast<int>(along.norm() * across.norm() / 16e-6);
    for (int i = 0; i < count; ++i) {
      add(middle + random_.uniform(-0.5, 0.5) * along + random_.uniform(-0.5, 0.5) * across,
          normal);
    }
  }

  void add_box(const Eigen::Vector3d& foot, const Eigen::Vector3d& size) {
    const PointCloud box = sample_surface(make_box(size, 0.02), 6000);
    const Eigen::Vector3d lift = foot + Eigen::Vector3d(0, 0, 0.5 * size.z());
    const Eigen::Vector3d center =
        0.5 * (box.positions.colwise().minCoeff() + box.positions.colwise().maxCoeff())
                  .transpose()
                  .cast<double>();
    for (Index i = 0; i < box.size(); ++i) {
      if (box.normal(i).z() < -0.5F) continue;
      add(box.position(i).cast<double>() - center + lift, box.normal(i).cast<double>());
    }
  }

  /// The shift of points along z, as by drift.
  std::function<double(const Eigen::Vector3d&)> bend = [](const Eigen::Vector3d&) { return 0.0; };

  PointCloud cloud(const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity()) const {
    PointCloud result;
    const auto count = static_cast<Eigen::Index>(positions_.size());
    result.positions.resize(count, 3);
    result.normals.resize(count, 3);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      result.positions.row(row) = (motion * positions_[i]).cast<float>().transpose();
      result.normals.row(row) = (motion.linear() * normals_[i]).cast<float>().transpose();
    }
    return result;
  }

 private:
  void add(const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
    positions_.push_back(position + noise_ * random_.normal() * normal +
                         Eigen::Vector3d(0, 0, bend(position)));
    const Eigen::Vector3d tilt(random_.normal(), random_.normal(), random_.normal());
    normals_.push_back((normal + 0.07 * tilt).normalized());
  }

  Random random_;
  double noise_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<Eigen::Vector3d> normals_;
};

/// A table of 1.2 m by 0.8 m at z = 0.
inline void add_table(CloudBuilder& builder,
                      const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  builder.add_rectangle(middle, {1.2, 0, 0}, {0, 0.8, 0});
}

inline void add_objects(CloudBuilder& builder,
                        const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  builder.add_box(middle + Eigen::Vector3d(0.2, 0.1, 0), {0.06, 0.16, 0.21});
  builder.add_box(middle + Eigen::Vector3d(-0.2, -0.1, 0), {0.1, 0.1, 0.05});
  builder.add_box(middle + Eigen::Vector3d(-0.3, 0.2, 0), {0.2, 0.15, 0.12});
}

}  // namespace symscene::testing
