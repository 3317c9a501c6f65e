#include "symscene/io/trajectory.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

constexpr const char* a_pose = "eight numbers: time tx ty tz qx qy qz qw";

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

}  // namespace symscene
