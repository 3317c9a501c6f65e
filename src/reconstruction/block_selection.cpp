#include "block_selection.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "depth_bounds.hpp"
#include "reconstruction/tsdf_volume.hpp"

namespace symscene {
namespace {

constexpr std::size_t search_rows_per_task = 16;
constexpr std::size_t slots_per_task = 4096;
constexpr float min_depth = 0.05F;  // from which the image of a block is bounded [m]

template <class Value>
std::vector<Value> joined(const std::vector<std::vector<Value>>& lists) {
  std::vector<Value> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// The block at a coordinate, rounded down; beyond the index's reach some block beyond it.
/// Truncation is one instruction, std::floor without SSE 4.1 a call.
int block_of(float coordinate) {
  constexpr int offset = 2 * BlockIndex::reach;
  const float bounded =
      std::clamp(coordinate, -static_cast<float>(offset), static_cast<float>(offset));
  return static_cast<int>(bounded + static_cast<float>(offset)) - offset;
}

/// Walks along the rays of a measurement through the blocks around the measured surface.
class BlockSearch {
 public:
  BlockSearch(const BlockSelection& selection, const Measurement& measurement,
              const Eigen::Isometry3d& T_world_camera)
      : selection_(selection),
        measurement_(measurement),
        block_size_(selection.options.voxel_size * TsdfBlock::edge),
        R_((T_world_camera.linear() / block_size_).cast<float>()),
        t_((T_world_camera.translation() / block_size_).cast<float>()),
        ray_x_(measurement.camera.column_rays()),
        ray_y_(measurement.camera.row_rays()),
        far_(static_cast<float>(0.25 * block_size_ *
                                std::min(measurement.camera.fx, measurement.camera.fy))) {}

  /// Adds the missing blocks of one row of pixels. `last` is the block that was looked up last.
  void search_row(Index v, Eigen::Vector3i& last, std::vector<Eigen::Vector3i>& found) const {
    const CameraIntrinsics& camera = measurement_.camera;
    for (Index u = 0; u < camera.width; ++u) {
      const std::uint32_t packed = measurement_.packed[std::size_t{v} * camera.width + u];
      if (packed == 0) continue;
      const float depth = static_cast<float>(packed >> 16) * Measurement::depth_unit;
      const bool is_between = ((u | v) & 1U) != 0;
      if (is_between && depth < far_) continue;
      search_ray(R_ * Eigen::Vector3f(ray_x_[u], ray_y_[v], 1.0F), depth, last, found);
    }
  }

 private:
  void search_ray(const Eigen::Vector3f& ray, float depth, Eigen::Vector3i& last,
                  std::vector<Eigen::Vector3i>& found) const {
    const auto band = static_cast<float>(truncation(depth));
    const int steps = 1 + static_cast<int>(4.0F * band / static_cast<float>(block_size_));
    for (int k = 0; k <= steps; ++k) {
      const float at =
          depth + band * (2.0F * static_cast<float>(k) / static_cast<float>(steps) - 1.0F);
      const Eigen::Vector3f place = t_ + at * ray;
      const Eigen::Vector3i block(block_of(place.x()), block_of(place.y()), block_of(place.z()));
      if (block == last) continue;
      last = block;
      if (BlockIndex::in_reach(block) && selection_.index.find(block) == BlockIndex::none) {
        found.push_back(block);
      }
    }
  }

  double truncation(double depth) const {
    const TsdfOptions& options = selection_.options;
    return std::clamp(options.truncation_sigmas * selection_.sensor.deviation(depth),
                      options.truncation, options.max_truncation);
  }

  const BlockSelection& selection_;
  const Measurement& measurement_;
  double block_size_;  ///< [m]
  Eigen::Matrix3f R_;  ///< from the camera's frame to blocks
  Eigen::Vector3f t_;
  std::vector<float> ray_x_, ray_y_;
  float far_;  ///< depth up to which every second pixel hits every block of a slanted surface [m]
};

/// Decides whether the ball around a block may be seen.
class VisibilityTest {
 public:
  VisibilityTest(const BlockSelection& selection, const Measurement& measurement,
                 const Eigen::Isometry3d& T_camera_world)
      : bounds_(measurement),
        everywhere_(bounds_.anywhere()),
        band_(static_cast<float>(selection.options.max_truncation)),
        fx_(static_cast<float>(measurement.camera.fx)),
        fy_(static_cast<float>(measurement.camera.fy)),
        cx_(static_cast<float>(measurement.camera.cx)),
        cy_(static_cast<float>(measurement.camera.cy)) {
    const double block_size = selection.options.voxel_size * TsdfBlock::edge;
    radius_ = static_cast<float>(0.5 * std::sqrt(3.0) * block_size);
    R_ = (T_camera_world.linear() * block_size).cast<float>();
    t_ = (T_camera_world * Eigen::Vector3d::Constant(0.5 * block_size)).cast<float>();
  }

  bool may_be_visible(const Eigen::Vector3i& block) const {
    const Eigen::Vector3f center = R_ * block.cast<float>() + t_;
    if (!(center.z() + radius_ > 0.0F)) return false;
    const float nearest = center.z() - radius_;
    const float farthest = nearest > min_depth ? farthest_around(center) : everywhere_;
    return farthest > 0.0F && nearest < farthest + band_;
  }

 private:
  /// The largest depth measured in the image of the ball around a block.
  float farthest_around(const Eigen::Vector3f& center) const {
    // Off the optical axis the image of a ball is longer than its radius over its distance.
    const float inverse = 1.0F / center.z();
    const float slant = center.norm() * inverse;
    const float reach = std::max(fx_, fy_) * radius_ * slant / (center.z() - radius_) + 1.0F;
    return bounds_.around(center.x() * fx_ * inverse + cx_, center.y() * fy_ * inverse + cy_,
                          reach);
  }

  DepthBounds bounds_;
  float everywhere_;  ///< [m]
  float band_;        ///< behind the surface [m]
  float fx_, fy_, cx_, cy_;
  float radius_;       ///< [m]
  Eigen::Matrix3f R_;  ///< from blocks to the camera's frame
  Eigen::Vector3f t_;
};

}  // namespace

std::vector<Eigen::Vector3i> BlockSelection::missing(
    const Measurement& measurement, const Eigen::Isometry3d& T_world_camera) const {
  const BlockSearch search(*this, measurement, T_world_camera);
  const std::size_t rows = measurement.camera.height;
  std::vector<std::vector<Eigen::Vector3i>> lists((rows + search_rows_per_task - 1) /
                                                  search_rows_per_task);
  parallel_for_blocks(rows, search_rows_per_task, [&](std::size_t begin, std::size_t end) {
    Eigen::Vector3i last = Eigen::Vector3i::Constant(BlockIndex::reach);
    for (std::size_t row = begin; row < end; ++row) {
      search.search_row(static_cast<Index>(row), last, lists[begin / search_rows_per_task]);
    }
  });
  return joined(lists);
}

std::vector<std::uint32_t> BlockSelection::visible(const Measurement& measurement,
                                                   const Eigen::Isometry3d& T_camera_world) const {
  const VisibilityTest test(*this, measurement, T_camera_world);
  std::vector<std::vector<std::uint32_t>> lists((index.size() + slots_per_task - 1) /
                                                slots_per_task);
  parallel_for_blocks(index.size(), slots_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      if (!test.may_be_visible(index.blocks()[slot])) continue;
      lists[begin / slots_per_task].push_back(static_cast<std::uint32_t>(slot));
    }
  });
  return joined(lists);
}

}  // namespace symscene
