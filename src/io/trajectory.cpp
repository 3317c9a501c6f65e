#include "symscene/io/trajectory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

constexpr const char* a_pose = "eight numbers: time tx ty tz qx qy qz qw";

/// How far the rows of a rotation matrix that was written with few digits may be from unit vectors
/// at right angles.
constexpr double rotation_tolerance = 0.02;

StampedPose parse_pose(const std::vector<std::string_view>& words, const std::string& where) {
  if (words.size() != 8) throw InputError(where, a_pose, fmt::format("{} words", words.size()));
  std::array<double, 8> numbers{};
  for (std::size_t i = 0; i < 8; ++i) {
    const auto value = to_number<double>(words[i]);
    if (!value || !std::isfinite(*value)) throw InputError(where, a_pose, in_quotes(words[i]));
    numbers[i] = *value;
  }
  Eigen::Quaterniond rotation(numbers[7], numbers[4], numbers[5], numbers[6]);
  const double largest = rotation.coeffs().cwiseAbs().maxCoeff();
  if (largest == 0.0) throw InputError(where, "a quaternion of some length", "zeros");
  rotation.coeffs() /= largest;  // so that no square over- or underflows
  StampedPose pose;
  pose.time = numbers[0];
  pose.T_world_camera.linear() = rotation.normalized().toRotationMatrix();
  pose.T_world_camera.translation() << numbers[1], numbers[2], numbers[3];
  return pose;
}

/// The next number of a matrix; may be infinite or none.
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

Trajectory parse_trajectory(std::string_view text, const std::string& name) {
  Trajectory trajectory;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::vector<std::string_view> words = words_of(without_comment(take_line(text)));
    if (words.empty()) continue;
    const std::string where = fmt::format("{}: line {}", name, line);
    trajectory.push_back(parse_pose(words, where));
    if (trajectory.size() < 2) continue;
    const double before = trajectory[trajectory.size() - 2].time;
    if (trajectory.back().time < before) {
      throw InputError(where, fmt::format("a time not before {}", before), std::string(words[0]));
    }
  }
  return trajectory;
}

Trajectory read_trajectory(const std::filesystem::path& path) {
  return parse_trajectory(read_file(path), path.string());
}

std::string format_trajectory(const Trajectory& trajectory) {
  std::string text;
  for (const StampedPose& pose : trajectory) {
    const Eigen::Vector3d t = pose.T_world_camera.translation();
    const Eigen::Quaterniond q(pose.T_world_camera.linear());
    text += fmt::format("{} {} {} {} {} {} {} {}\n", pose.time, t.x(), t.y(), t.z(), q.x(), q.y(),
                        q.z(), q.w());
  }
  return text;
}

void write_trajectory(const std::filesystem::path& path, const Trajectory& trajectory) {
  write_file_atomically(path, format_trajectory(trajectory));
}

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
