#include "carry_line.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace symscene {
namespace {

/// The angle plus full turns that lies in [−π, π].
double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

/// The turn about the vertical that takes one orientation to another.
double turn_between(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::Matrix3d turn = to * from.transpose();
  return std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1));
}

int steps_for(double length, double angle, double step) {
  constexpr double turn_step = 0.1;
  return std::max({1, static_cast<int>(std::ceil(length / step)),
                   static_cast<int>(std::ceil(std::abs(angle) / turn_step))});
}

}  // namespace

std::vector<Eigen::Isometry3d> upright_line(const Eigen::Isometry3d& from,
                                            const Eigen::Isometry3d& goal,
                                            const Eigen::Vector2d& base, double raise,
                                            double step) {
  std::vector<Eigen::Isometry3d> poses{from};
  const auto go_vertically = [&](double z) {
    const Eigen::Isometry3d begin = poses.back();
    const double way = z - begin.translation().z();
    const int steps = steps_for(std::abs(way), 0.0, step);
    for (int k = 1; k <= steps; ++k) {
      poses.push_back(begin);
      poses.back().translation().z() += way * k / steps;
    }
  };
  const double top = std::max(from.translation().z(), goal.translation().z()) + raise;
  go_vertically(top);
  const Eigen::Vector2d out = from.translation().head<2>() - base,
                        in = goal.translation().head<2>() - base;
  const double angle0 = std::atan2(out.y(), out.x());
  const double sweep = wrapped(std::atan2(in.y(), in.x()) - angle0);
  // The hand turns with the arm; what is left of its turn is the shorter way.
  const double turn = sweep + wrapped(turn_between(from.linear(), goal.linear()) - sweep);
  const double radius = std::max(out.norm(), in.norm());
  const int around =
      steps_for(std::abs(sweep) * radius + std::abs(in.norm() - out.norm()), turn, step);
  for (int k = 1; k <= around; ++k) {
    const double share = static_cast<double>(k) / around;
    const double angle = angle0 + share * sweep;
    const double distance = out.norm() + share * (in.norm() - out.norm());
    Eigen::Isometry3d pose = from;
    pose.linear() = Eigen::AngleAxisd(share * turn, Eigen::Vector3d::UnitZ()) * from.linear();
    pose.translation() << base.x() + distance * std::cos(angle),
        base.y() + distance * std::sin(angle), top;
    poses.push_back(pose);
  }
  go_vertically(goal.translation().z());
  return poses;
}

}  // namespace symscene
