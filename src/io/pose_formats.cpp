#include "pose_formats.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

/// Largest error of a rotation matrix, ‖R Rᵀ − I‖, that rounding in the file explains.
constexpr double rotation_tolerance = 0.02;

/// The next number of a matrix; may be infinite or NaN.
double take_number(std::string_view& text, const std::string& name) {
  const std::string_view word = next_word(text);
  const auto value = to_number<double>(word);
  if (value) return *value;
  throw InputError(name, "the 16 numbers of a 4×4 matrix",
                   word.empty() ? "the end of the file" : in_quotes(word));
}

Eigen::Matrix4d take_matrix(std::string_view& text, const std::string& name) {
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix(row, column) = take_number(text, name);
  }
  return matrix;
}

Eigen::Isometry3d to_pose(const Eigen::Matrix4d& matrix, const std::string& name) {
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const double error = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  const double last = (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm();
  if (!(matrix.allFinite() && error <= rotation_tolerance && last <= rotation_tolerance &&
        rotation.determinant() > 0)) {
    throw InputError(name, "a matrix of rotation and translation", "another");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

}  // namespace

std::optional<Eigen::Isometry3d> parse_pose_matrix(std::string_view text, const std::string& name) {
  const Eigen::Matrix4d matrix = take_matrix(text, name);
  if (const std::string_view extra = next_word(text); !extra.empty()) {
    throw InputError(name, "the 16 numbers of a 4×4 matrix", "more: " + in_quotes(extra));
  }
  if (!matrix.allFinite()) return std::nullopt;
  return to_pose(matrix, name);
}

Trajectory parse_trajectory_log(std::string_view text, const std::string& name) {
  Trajectory trajectory;
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
    const std::string where = fmt::format("{}: pose {}", name, trajectory.size());
    for (int i = 0; i < 3; ++i) {
      if (i > 0) word = next_word(text);
      const auto number = to_number<std::int64_t>(word);
      if (!number) throw InputError(where, "three whole numbers before a matrix", in_quotes(word));
      if (i == 0) trajectory.push_back({static_cast<double>(*number), {}});
    }
    trajectory.back().T_world_camera = to_pose(take_matrix(text, where), where);
  }
  return trajectory;
}

std::optional<Eigen::Isometry3d> pose_at(const Trajectory& trajectory, double time,
                                         double largest_gap) {
  const auto after =
      std::lower_bound(trajectory.begin(), trajectory.end(), time,
                       [](const StampedPose& pose, double t) { return pose.time < t; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->time == time) return after->T_world_camera;
  if (after == trajectory.begin()) return std::nullopt;
  const StampedPose& a = *(after - 1);
  const StampedPose& b = *after;
  if (b.time - a.time > largest_gap) return std::nullopt;
  const double share = (time - a.time) / (b.time - a.time);
  const Eigen::Quaterniond q_a(a.T_world_camera.linear());
  const Eigen::Quaterniond q_b(b.T_world_camera.linear());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = q_a.slerp(share, q_b).toRotationMatrix();
  pose.translation() =
      (1.0 - share) * a.T_world_camera.translation() + share * b.T_world_camera.translation();
  return pose;
}

}  // namespace symscene
