#include "surfels.hpp"

#include <bit>
#include <cmath>

#include <tbb/parallel_sort.h>

#include "core/parallel.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr std::size_t block_size = 4096;

/// The voxel of a surfel, packed so that keys sort by z, y, x.
std::uint64_t voxel_key(const Eigen::Vector3f& p, double voxel_size) {
  constexpr std::int64_t middle = 1 << 20;  // voxels have 21 bits per axis
  const auto cell = [&](float x) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / voxel_size)) +
                                      middle);
  };
  return (cell(p.z()) << 42U) | (cell(p.y()) << 21U) | cell(p.x());
}

using KeyedIndex = std::pair<std::uint64_t, Index>;

std::vector<KeyedIndex> sorted_by_voxel(const std::vector<Surfel>& surfels, double voxel_size) {
  std::vector<KeyedIndex> keys(surfels.size());
  parallel_for_blocks(keys.size(), block_size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      keys[i] = {voxel_key(surfels[i].position, voxel_size), static_cast<Index>(i)};
    }
  });
  tbb::parallel_sort(keys.begin(), keys.end());  // keys are unique, so the order is too
  return keys;
}

/// The weighted mean of surfels; its object is the one with the most weight.
class SurfelMean {
 public:
  void add(const Surfel& s) {
    const double w = s.weight;
    position_ += w * s.position.cast<double>();
    normal_ += w * s.normal.cast<double>();
    color_ += w * s.color.cast<double>();
    weight_ += w;
    frames_ |= s.frames;
    for (auto& [object, votes] : votes_) {
      if (object == s.object) {
        votes += w;
        return;
      }
    }
    votes_.emplace_back(s.object, w);
  }

  bool empty() const { return votes_.empty(); }
  int frames() const { return std::popcount(frames_); }

  Surfel mean() const {
    Surfel result;
    result.position = (position_ / weight_).cast<float>();
    result.normal = normal_.normalized().cast<float>();
    result.color = (color_ / weight_).cast<float>();
    result.weight = static_cast<float>(weight_);
    result.frames = frames_;
    double most = -1.0;
    for (const auto& [object, votes] : votes_) {
      if (votes > most || (votes == most && object < result.object)) {
        most = votes;
        result.object = object;
      }
    }
    return result;
  }

 private:
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d color_ = Eigen::Vector3d::Zero();
  double weight_ = 0.0;
  std::uint64_t frames_ = 0;
  std::vector<std::pair<Index, double>> votes_;
};

}  // namespace

std::vector<Surfel> averaged_in_voxels(const std::vector<Surfel>& surfels, double voxel_size,
                                       int min_frames) {
  const std::vector<KeyedIndex> keys = sorted_by_voxel(surfels, voxel_size);
  std::vector<Surfel> means;
  for (std::size_t begin = 0; begin < keys.size();) {
    // A voxel may hold both sides of a thin wall: surfels that face away from the first are
    // averaged separately.
    const Eigen::Vector3f facing = surfels[keys[begin].second].normal;
    SurfelMean front;
    SurfelMean back;
    std::size_t end = begin;
    for (; end < keys.size() && keys[end].first == keys[begin].first; ++end) {
      const Surfel& surfel = surfels[keys[end].second];
      (surfel.normal.dot(facing) >= 0.0F ? front : back).add(surfel);
    }
    for (const SurfelMean& side : {front, back}) {
      if (!side.empty() && side.frames() >= min_frames) means.push_back(side.mean());
    }
    begin = end;
  }
  return means;
}

std::vector<Surfel> flattened(const std::vector<Surfel>& surfels, double smoothing) {
  Points positions(static_cast<Eigen::Index>(surfels.size()), 3);
  for (Index i = 0; i < surfels.size(); ++i) positions.row(i) = surfels[i].position.transpose();
  const auto radius = static_cast<float>(2.0 * smoothing);
  const CellList cells(positions, radius);
  std::vector<Surfel> result = surfels;
  parallel_for_blocks(surfels.size(), block_size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Surfel& own = surfels[i];
      double weight = 0.0;
      double offset = 0.0;
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      cells.for_each_within(own.position, radius, [&](Index j, float squared_distance) {
        const Surfel& other = surfels[j];
        if (own.normal.dot(other.normal) < 0.5F) return;
        const double w = other.weight * std::exp(-0.5 * squared_distance / (smoothing * smoothing));
        weight += w;
        offset += w * own.normal.dot(other.position - own.position);
        normal += w * other.normal.cast<double>();
      });
      result[i].position += static_cast<float>(offset / weight) * own.normal;
      result[i].normal = normal.normalized().cast<float>();
    }
  });
  return result;
}

}  // namespace symscene
