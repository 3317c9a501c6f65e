#pragma once

#include <vector>

#include <Eigen/Core>

namespace symscene {

/// The vertices of the convex hull of points in the plane, counter-clockwise (Andrew 1979).
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// The unit direction of an edge of the rectangle of least area around points in the plane. One of
/// its edges lies on an edge of the convex hull (Freeman and Shapira 1975).
Eigen::Vector2d least_rectangle(const std::vector<Eigen::Vector2d>& points);

}  // namespace symscene
