#include "viewer/run_tracks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <string_view>

namespace symscene {
namespace {

std::vector<std::uint8_t> bytes_of(const nlohmann::json& text) {
  constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.get<std::string>()) {
    if (c == '=') break;
    bits = (bits << 6) | static_cast<std::uint32_t>(alphabet.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>((bits >> count) & 0xFF));
  }
  return bytes;
}

/// Little endian numbers in base64, as this machine has them too.
template <class Number>
std::vector<Number> numbers_of(const nlohmann::json& text) {
  const std::vector<std::uint8_t> bytes = bytes_of(text);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

struct Track {
  std::vector<std::uint32_t> moments;
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Quaterniond> rotations;
};

Track decoded(const nlohmann::json& payload) {
  Track track{numbers_of<std::uint32_t>(payload.at("moments")), {}, {}};
  const nlohmann::json& positions = payload.at("positions");
  const bool quantized = positions.at("encoding") == "u16";
  const auto steps = numbers_of<std::uint16_t>(positions.at("data"));
  const auto floats = numbers_of<float>(positions.at("data"));
  const auto quaternions = numbers_of<std::int16_t>(payload.at("rotations"));
  for (std::size_t i = 0; i < track.moments.size(); ++i) {
    Eigen::Vector3d position;
    for (std::size_t k = 0; k < 3; ++k) {
      position[static_cast<Eigen::Index>(k)] =
          quantized ? positions.at("min").at(k).get<double>() +
                          steps[3 * i + k] * positions.at("step").at(k).get<double>()
                    : static_cast<double>(floats[3 * i + k]);
    }
    track.positions.push_back(position);
    const auto* q = &quaternions[4 * i];
    track.rotations.push_back(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
  }
  return track;
}

/// Greatest errors of position [m] and angle [rad] over all moments, one second apart.
std::array<double, 2> errors_of(const Track& track, const std::vector<Eigen::Isometry3d>& poses) {
  std::array<double, 2> most{};
  std::size_t k = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    while (k + 2 < track.moments.size() && track.moments[k + 1] <= i) ++k;
    const std::size_t next = std::min(k + 1, track.moments.size() - 1);
    const double span = track.moments[next] - track.moments[k];
    const double t = span > 0 ? (static_cast<double>(i) - track.moments[k]) / span : 0.0;
    const Eigen::Vector3d position = (1 - t) * track.positions[k] + t * track.positions[next];
    const Eigen::Quaterniond rotation = track.rotations[k].slerp(t, track.rotations[next]);
    most[0] = std::max(most[0], (position - poses[i].translation()).norm());
    most[1] = std::max(most[1], rotation.angularDistance(Eigen::Quaterniond(poses[i].linear())));
  }
  return most;
}

/// Moves, rests and creeps: steps of very different lengths, from none to `stride`. [m]
std::vector<Eigen::Isometry3d> random_way(unsigned seed, int moments, double stride) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> pace(0, 3);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> way;
  double speed = 0.0;
  for (int i = 0; i < moments; ++i) {
    if (i % 10 == 0)
      speed = std::array{0.0, 1e-4, 0.01, 1.0}[static_cast<std::size_t>(pace(random))];
    const Eigen::Vector3d turn(normal(random), normal(random), normal(random));
    pose.translation() += speed * stride * Eigen::Vector3d(normal(random), normal(random), 0.3);
    pose.rotate(Eigen::AngleAxisd(speed * 0.3 * turn.norm(), turn.normalized()));
    way.push_back(pose);
  }
  return way;
}

TEST(RunTracks, KeepEveryPoseWithinATenthOfAMillimetreAndMilliradian) {
  for (const double stride : {0.02, 0.1, 5.0}) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const auto way = random_way(seed, 200, stride);
      const auto [position, angle] = errors_of(decoded(track_payload(way)), way);
      // Each coordinate is rounded by up to a tenth of a millimetre, and a pose may be left out.
      EXPECT_LT(position, 3e-4) << "stride " << stride << ", seed " << seed;
      EXPECT_LT(angle, 3e-4) << "stride " << stride << ", seed " << seed;
    }
  }
}

TEST(RunTracks, OfARestingSolidAreItsFirstAndLastMoment) {
  const std::vector<Eigen::Isometry3d> still(500, Eigen::Isometry3d::Identity());
  EXPECT_EQ(kept_moments(still), (PointIndices{0, 499}));
  EXPECT_EQ(kept_moments({Eigen::Isometry3d::Identity()}), PointIndices{0});
}

TEST(RunTracks, KeepWhereAMotionBeginsAndEnds) {
  std::vector<Eigen::Isometry3d> way(100, Eigen::Isometry3d::Identity());
  for (std::size_t i = 40; i < way.size(); ++i)
    way[i].translation().x() = 0.1 * static_cast<double>(std::min<std::size_t>(i, 43) - 39);
  EXPECT_EQ(kept_moments(way), (PointIndices{0, 39, 40, 41, 42, 43, 99}));
}

TEST(RunTracks, TakeAtMostEighteenBytesPerPose) {
  const auto way = random_way(3, 1000, 0.1);
  const std::string text = track_payload(way).dump();
  EXPECT_LT(text.size(), 18 * way.size() * 4 / 3 + 500);
}

}  // namespace
}  // namespace symscene
