#include "view_candidate_choice.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "io/view_costs.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/camera_file.hpp"
#include "symscene/io/intrinsics.hpp"
#include "symscene/io/trajectory.hpp"
#include "symscene/view_planning/view_candidates.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* on_sphere = "sphere";

/// Up where no table tells: the mean normal of what was seen, as views of a scene look down on it.
Eigen::Vector3d up_of(const SegmentationResult& result) {
  if (result.table) return result.table->normal.normalized();
  const Eigen::Vector3d mean =
      result.cloud.normals.rows() > 0
          ? Eigen::Vector3d(result.cloud.normals.colwise().mean().cast<double>().transpose())
          : Eigen::Vector3d::Zero();
  return mean.norm() > 1e-6 ? Eigen::Vector3d(mean.normalized()) : Eigen::Vector3d::UnitZ();
}

/// A ball around the objects or, without any, around all points.
struct Ball {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

Ball ball_around(const SegmentationResult& result) {
  PointIndices indices;
  for (const SceneObject& object : result.objects)
    indices.insert(indices.end(), object.points.begin(), object.points.end());
  const Points points = indices.empty() ? result.cloud.positions
                                        : Points(result.cloud.positions(indices, Eigen::all));
  if (points.rows() == 0) return {};
  const Box box = bounding_box(points);
  return {(0.5F * (box.min + box.max)).cast<double>(),
          0.5 * static_cast<double>(box.extent().norm())};
}

/// From which the ball fills the image.
double filling_distance(const Ball& ball, const CameraIntrinsics& camera) {
  constexpr double margin = 1.1;
  const double half_view = std::atan(std::min(static_cast<double>(camera.width) / camera.fx,
                                              static_cast<double>(camera.height) / camera.fy) /
                                     2.0);
  return margin * std::max(ball.radius, 1e-3) / std::sin(half_view);
}

CameraIntrinsics camera_of_file(const fs::path& path) {
  return is_camera_file(path) ? read_camera_model(path).intrinsics : read_intrinsics(path);
}

}  // namespace

void ViewCandidateChoice::add_to(Arguments& arguments) {
  arguments.text(
      "--candidates", "sphere|FILE", candidates,
      "views to choose from: 34 on a half sphere over the objects (sphere), or a file of "
      "poses of the camera in the world, a line \"time tx ty tz qx qy qz qw\" each "
      "(default: sphere)");
  arguments.file("--camera", camera_file,
                 "intrinsics.txt or camera.yaml of the camera that takes the views (default: that "
                 "of the input)");
  arguments.file("--costs", costs,
                 "text file with a number per candidate, such as the time of the motion there, "
                 "weighed by the option cost_weight; inf: it cannot be reached");
}

std::vector<fs::path> ViewCandidateChoice::files() const {
  return {candidates == on_sphere ? "" : candidates, camera_file, costs};
}

CameraIntrinsics ViewCandidateChoice::camera(
    const fs::path& folder, const std::optional<CameraIntrinsics>& of_input) const {
  const fs::path beside = folder / "intrinsics.txt";
  std::optional<CameraIntrinsics> found = of_input;
  fs::path source = "--intrinsics";
  if (!camera_file.empty()) {
    source = camera_file;
    found = camera_of_file(camera_file);
  } else if (!found && fs::is_regular_file(beside)) {
    source = beside;
    found = read_intrinsics(beside);
  }
  if (!found)
    throw InputError("--camera", "a file with the intrinsics of the camera of the views",
                     "none, and no intrinsics.txt in " + folder.string());
  if (found->pixels() == 0 || !(found->fx > 0.0) || !(found->fy > 0.0))
    throw InputError(source.string(), "a camera with an image size and focal lengths",
                     fmt::format("{}x{}", found->width, found->height));
  return *found;
}

std::vector<Eigen::Isometry3d> ViewCandidateChoice::poses(const SegmentationResult& result,
                                                          const CameraIntrinsics& camera,
                                                          const SphereOptions& sphere) const {
  if (candidates == on_sphere) {
    const Ball ball = ball_around(result);
    const double nearest = sphere.min_depth + ball.radius;
    return views_on_sphere(
        ball.center, up_of(result),
        sphere.radius > 0.0 ? sphere.radius : std::max(nearest, filling_distance(ball, camera)));
  }
  std::vector<Eigen::Isometry3d> poses;
  for (const StampedPose& pose : read_trajectory(candidates)) poses.push_back(pose.T_world_camera);
  if (poses.empty()) throw InputError(candidates, "at least one pose", "none");
  return poses;
}

std::vector<double> ViewCandidateChoice::read_costs(std::size_t count) const {
  if (costs.empty()) return {};
  std::vector<double> numbers = parse_view_costs(read_file(costs), costs.string());
  if (numbers.size() != count)
    throw InputError(costs.string(), fmt::format("{} numbers, one per candidate", count),
                     std::to_string(numbers.size()));
  return numbers;
}

}  // namespace symscene::app
