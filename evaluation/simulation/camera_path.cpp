#include "symscene/simulation/camera_path.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/looking_at.hpp"
#include "core/random.hpp"
#include "hand_shake.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::uint64_t shake_stream = std::uint64_t{2}
                                       << 32U;  // distinct from the streams of the frames

Eigen::Isometry3d arc_pose(const CameraArcOptions& options, int frame) {
  const double t = options.frames > 1 ? static_cast<double>(frame) / (options.frames - 1) : 0.5;
  const double heading = options.arc * (t - 0.5);
  const double elevation = options.min_elevation + (options.max_elevation - options.min_elevation) *
                                                       std::sin(std::numbers::pi * t);
  const Eigen::Vector3d target(0, 0, options.target_height);
  const Eigen::Vector3d back(std::cos(elevation) * std::cos(heading),
                             std::cos(elevation) * std::sin(heading), std::sin(elevation));
  return looking_at(target + options.radius * back, target);
}

/// Band-limited noise: a sum of sine waves, one in each part of the band. Its variance is one, its
/// magnitude at most four.
class BandNoise {
 public:
  BandNoise(double low, double high, Random& random) {
    for (std::size_t k = 0; k < waves_.size(); ++k) {
      const double part = (static_cast<double>(k) + random.uniform()) / wave_count;
      waves_[k] = {2.0 * std::numbers::pi * (low + part * (high - low)),
                   random.uniform(0.0, 2.0 * std::numbers::pi)};
    }
  }

  double at(double time) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += std::sin(wave.frequency * time + wave.phase);
    return sum * std::sqrt(2.0 / wave_count);
  }

 private:
  static constexpr int wave_count = 8;
  struct Wave {
    double frequency = 0.0;  // [rad/s]
    double phase = 0.0;
  };
  std::array<Wave, wave_count> waves_;
};

}  // namespace

void CameraArcOptions::validate() const {
  check_fields(*this);
  require_option(max_elevation >= min_elevation, "max_elevation", "at least min_elevation",
                 max_elevation);
}

CameraIntrinsics CameraArcOptions::intrinsics() const {
  return {static_cast<Index>(width), static_cast<Index>(height), focal_length, focal_length,
          0.5 * (width - 1),         0.5 * (height - 1)};
}

std::vector<Eigen::Isometry3d> camera_arc(const CameraArcOptions& options) {
  options.validate();
  std::vector<Eigen::Isometry3d> poses;
  for (int frame = 0; frame < options.frames; ++frame) poses.push_back(arc_pose(options, frame));
  return poses;
}

void HandShakeOptions::validate() const {
  check_fields(*this);
  require_option(max_frequency >= min_frequency, "max_frequency", "at least min_frequency",
                 max_frequency);
}

std::vector<Eigen::Isometry3d> shaken(std::vector<Eigen::Isometry3d> path, double frame_rate,
                                      const HandShakeOptions& options, std::uint64_t seed) {
  options.validate();
  require_option(frame_rate > 0, "frame_rate", "a positive number", frame_rate);
  Random random(seed, shake_stream);
  std::vector<BandNoise> noise;
  for (int k = 0; k < 6; ++k)
    noise.emplace_back(options.min_frequency, options.max_frequency, random);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double t = static_cast<double>(i) / frame_rate;
    const Eigen::Vector3d shift(noise[0].at(t), noise[1].at(t), noise[2].at(t));
    const Eigen::Vector3d turn(noise[3].at(t), noise[4].at(t), noise[5].at(t));
    path[i].translate(options.translation * shift);
    path[i].rotate(Eigen::AngleAxisd(options.rotation * turn.norm(), turn.normalized()));
  }
  return path;
}

}  // namespace symscene
