#include "surface_distance.hpp"

#include <algorithm>
#include <cmath>

#include "core/spacing.hpp"

namespace symscene {
namespace {

constexpr float edge = 1.0F / 48.0F;  ///< of the grid's cells
constexpr float pad = 0.1F;           ///< of the grid around the samples

}  // namespace

SurfaceDistance::SurfaceDistance(const PointCloud& samples)
    : samples_(samples),
      spacing_(median_spacing(samples.positions).value_or(edge)),
      cells_(samples.positions, std::max(2.0F * spacing_, edge / 4.0F)) {
  const Box box = bounding_box(samples.positions).padded(pad);
  low_ = box.min;
  size_ = ((box.extent() / edge).array().ceil().cast<int>()).max(1);
  nearest_.assign(static_cast<std::size_t>(size_.prod()), CellList::none);
  seed_cells();
  spread(1);
  spread(-1);
  spread(1);
}

std::size_t SurfaceDistance::cell_of(const Eigen::Vector3f& point) const {
  const Eigen::Array3i at = ((point - low_) / edge)
                                .array()
                                .floor()
                                .max(0.0F)
                                .min(size_.cast<float>().array() - 1.0F)
                                .cast<int>();
  return static_cast<std::size_t>((at.z() * size_.y() + at.y()) * size_.x() + at.x());
}

Eigen::Vector3f SurfaceDistance::center_of(std::size_t cell) const {
  const auto k = static_cast<int>(cell);
  const Eigen::Vector3i at(k % size_.x(), k / size_.x() % size_.y(), k / size_.x() / size_.y());
  return low_ + edge * (at.cast<float>().array() + 0.5F).matrix();
}

void SurfaceDistance::seed_cells() {
  for (Index i = 0; i < samples_.size(); ++i) {
    const std::size_t cell = cell_of(samples_.position(i));
    const Eigen::Vector3f center = center_of(cell);
    Index& nearest = nearest_[cell];
    if (nearest == CellList::none || (samples_.position(i) - center).squaredNorm() <
                                         (samples_.position(nearest) - center).squaredNorm())
      nearest = i;
  }
}

/// One sweep of the vector distance transform (Danielsson 1980), forwards or backwards.
void SurfaceDistance::spread(int direction) {
  const auto count = static_cast<int>(nearest_.size());
  const int row = size_.x(), slice = size_.x() * size_.y();
  for (int n = 0; n < count; ++n) {
    const int k = direction > 0 ? n : count - 1 - n;
    const Eigen::Vector3i at(k % row, k / row % size_.y(), k / slice);
    const Eigen::Vector3f center = center_of(static_cast<std::size_t>(k));
    Index& best = nearest_[static_cast<std::size_t>(k)];
    float least = best == CellList::none ? std::numeric_limits<float>::max()
                                         : (samples_.position(best) - center).squaredNorm();
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const Eigen::Vector3i other = at + Eigen::Vector3i(dx, dy, dz);
          if ((other.array() < 0).any() || (other.array() >= size_.array()).any()) continue;
          const Index sample = nearest_[static_cast<std::size_t>(k + dx + dy * row + dz * slice)];
          if (sample == CellList::none || sample == best) continue;
          const float squared = (samples_.position(sample) - center).squaredNorm();
          if (squared >= least) continue;
          least = squared;
          best = sample;
        }
      }
    }
  }
}

float SurfaceDistance::distance(const Eigen::Vector3f& point, Index sample, float reach) const {
  const Eigen::Vector3f apart = point - samples_.position(sample);
  const float height = samples_.normal(sample).dot(apart);
  const float squared = apart.squaredNorm();
  const float sideways = std::max(squared - height * height, 0.0F);
  return std::sqrt(std::max(squared - std::min(sideways, reach * reach), 0.0F));
}

SurfaceDistance::Match SurfaceDistance::coarse(const Eigen::Vector3f& point) const {
  const Index sample = nearest_[cell_of(point)];
  return {sample, distance(point, sample, edge)};
}

SurfaceDistance::Match SurfaceDistance::nearest(const Eigen::Vector3f& point) const {
  const Index guess = nearest_[cell_of(point)];
  const float bound = (samples_.position(guess) - point).norm();
  const Index found = cells_.nearest(point, bound * 1.001F).first;
  const Index sample = found == CellList::none ? guess : found;
  return {sample, distance(point, sample, spacing_)};
}

}  // namespace symscene
