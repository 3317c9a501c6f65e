#pragma once

#include <vector>

#include <Eigen/Geometry>

namespace symscene {

/// Poses of a tool that carries an object upright: straight up to `raise` above the higher end,
/// then on an arc about the vertical axis through `base` to above the goal, with the orientation
/// turning evenly about the vertical, and down to it. `step`: greatest distance between two of them
/// [m]; turns are at most 0.1 rad. The first pose is `from`. `from` and `goal` differ by a turn
/// about the vertical and a translation; z up.
std::vector<Eigen::Isometry3d> upright_line(const Eigen::Isometry3d& from,
                                            const Eigen::Isometry3d& goal,
                                            const Eigen::Vector2d& base, double raise, double step);

}  // namespace symscene
