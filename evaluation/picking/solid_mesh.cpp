#include "solid_mesh.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/rigid_motion.hpp"
#include "simulation/shapes.hpp"

namespace symscene {

TriangleMesh box_mesh(const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d bottom(box.center().x(), box.center().y(), box.min().z());
  return transformed(make_box(box.sizes(), box.sizes().maxCoeff()),
                     Eigen::Isometry3d(Eigen::Translation3d(bottom)));
}

TriangleMesh capsule_mesh(const Capsule& capsule) {
  constexpr int steps = 4;  // of a quarter of a circle
  constexpr int segments = 16;
  const Eigen::Vector3d way = capsule.end - capsule.begin;
  std::vector<ProfilePoint> profile;
  const auto add = [&](double centre, int step) {
    const double angle = 0.5 * std::numbers::pi * step / steps;
    // A profile starts and ends exactly on its axis.
    const double radius = std::abs(step) == steps ? 0.0 : capsule.radius * std::cos(angle);
    profile.push_back({radius, centre + capsule.radius * std::sin(angle)});
  };
  for (int step = -steps; step <= 0; ++step) add(0.0, step);
  for (int step = way.norm() > 0.0 ? 0 : 1; step <= steps; ++step) add(way.norm(), step);
  Eigen::Isometry3d pose(Eigen::Translation3d(capsule.begin));
  pose.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), way).toRotationMatrix();
  const double longest = way.norm() + 2.0 * capsule.radius;
  return transformed(make_revolution(profile, segments, longest), pose);
}

}  // namespace symscene
