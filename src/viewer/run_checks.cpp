#include "viewer/run_checks.hpp"

#include <cmath>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr const char* where = "the recording of a run";

void require_time(const char* what, double time, double before) {
  if (!std::isfinite(time))
    throw InputError(where, fmt::format("finite times of {}", what), "one that is not finite");
  if (time < before)
    throw InputError(where, fmt::format("times of {} that never fall", what),
                     fmt::format("{} s after {} s", time, before));
}

template <class Timed>
void require_times(const char* what, const std::vector<Timed>& all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    require_time(what, all[i].time, all[i > 0 ? i - 1 : 0].time);
}

void require_moments(const std::vector<double>& times) {
  for (std::size_t i = 0; i < times.size(); ++i)
    require_time("moments", times[i], times[i > 0 ? i - 1 : 0]);
}

void require_rigid(const Eigen::Isometry3d& pose, const RecordedSolid& solid, double time) {
  const bool finite = pose.matrix().allFinite();
  const Eigen::Matrix3d rotation = pose.linear();
  // Poses from single precision and long products deviate a little.
  if (finite && (rotation.transpose() * rotation).isIdentity(1e-3) && rotation.determinant() > 0)
    return;
  throw InputError(where, "rigid poses",
                   fmt::format("a pose of '{}' at {} s that is not {}", solid.name, time,
                               finite ? "a rotation" : "finite"));
}

void require_poses(const RunRecording& recording) {
  const std::size_t moments = recording.times.size();
  if (recording.poses.size() != moments)
    throw InputError(where, fmt::format("poses of {} moments", moments),
                     fmt::format("those of {}", recording.poses.size()));
  for (std::size_t i = 0; i < moments; ++i) {
    const std::vector<Eigen::Isometry3d>& poses = recording.poses[i];
    if (poses.size() != recording.solids.size())
      throw InputError(where, fmt::format("{} poses, one per solid", recording.solids.size()),
                       fmt::format("{} at {} s", poses.size(), recording.times[i]));
    for (std::size_t k = 0; k < poses.size(); ++k)
      require_rigid(poses[k], recording.solids[k], recording.times[i]);
  }
}

void require_mesh(const TriangleMesh& mesh, const std::string& name) {
  if (!mesh.vertices.allFinite())
    throw InputError(where, "finite vertices", fmt::format("one of '{}' that is not", name));
  const auto vertices = static_cast<Index>(mesh.vertices.rows());
  if (mesh.triangles.size() > 0 && mesh.triangles.maxCoeff() >= vertices)
    throw InputError(where, fmt::format("triangles of the {} vertices of '{}'", vertices, name),
                     fmt::format("vertex {}", mesh.triangles.maxCoeff()));
}

}  // namespace

void require_playable(const RunRecording& recording) {
  require_moments(recording.times);
  require_poses(recording);
  require_times("beliefs", recording.beliefs);
  require_times("events", recording.events);
  for (const RecordedSolid& solid : recording.solids) require_mesh(solid.mesh, solid.name);
  for (const RecordedBelief& belief : recording.beliefs)
    for (const BelievedObject& object : belief.objects) require_mesh(object.mesh, object.name);
}

}  // namespace symscene
