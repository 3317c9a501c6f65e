#include "run_tracks.hpp"

#include <cmath>
#include <cstdint>

#include "core/base64.hpp"
#include "core/little_endian.hpp"
#include "encoding.hpp"

namespace symscene {
namespace {

using nlohmann::json;

constexpr double same_position = 1e-4;  // [m]
constexpr double same_rotation = 1e-4;  // [rad]

bool same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  if ((a.translation() - b.translation()).norm() > same_position) return false;
  // The Frobenius norm of the difference of two rotations is √8 sin(angle / 2).
  return (a.linear() - b.linear()).norm() <= std::sqrt(2.0) * same_rotation;
}

std::string encode_rotations(const std::vector<Eigen::Isometry3d>& poses,
                             const PointIndices& kept) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(8 * kept.size());
  for (const Index moment : kept) {
    const Eigen::Vector4d xyzw = Eigen::Quaterniond(poses[moment].linear()).normalized().coeffs();
    for (const double value : xyzw)
      append_little_endian(bytes, static_cast<std::int16_t>(std::lround(32767.0 * value)));
  }
  return base64(bytes);
}

json encode_translations(const std::vector<Eigen::Isometry3d>& poses, const PointIndices& kept) {
  Points positions(static_cast<Eigen::Index>(kept.size()), 3);
  for (Eigen::Index row = 0; row < positions.rows(); ++row) {
    const Index moment = kept[static_cast<std::size_t>(row)];
    positions.row(row) = poses[moment].translation().cast<float>().transpose();
  }
  return encode_positions(positions);
}

}  // namespace

PointIndices kept_moments(const std::vector<Eigen::Isometry3d>& poses) {
  PointIndices kept;
  // The last pose that was kept is the reference, so that a slow motion is not lost.
  std::size_t last = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool end = i == 0 || i + 1 == poses.size();
    if (!end && same(poses[i], poses[last]) && same(poses[i + 1], poses[last])) continue;
    kept.push_back(static_cast<Index>(i));
    last = i;
  }
  return kept;
}

json track_payload(const std::vector<Eigen::Isometry3d>& poses) {
  const PointIndices kept = kept_moments(poses);
  std::vector<std::uint8_t> moments;
  for (const Index moment : kept) append_little_endian(moments, moment);
  return {{"moments", base64(moments)},
          {"positions", encode_translations(poses, kept)},
          {"rotations", encode_rotations(poses, kept)}};
}

}  // namespace symscene
