#include "page_sweep.hpp"

#include <algorithm>

#include "frame_pose.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene::app {
namespace {

constexpr Index most_played = 60;
constexpr std::size_t shown_width = 160;  // [px]; 60 frames take 1.5 MB of the page

struct PosedFrame {
  std::size_t frame;
  Eigen::Isometry3d T_world_camera;
};

std::vector<PosedFrame> posed_frames(const DepthSequence& sequence, const Trajectory& trajectory) {
  std::vector<PosedFrame> placed;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (const auto pose = frame_pose(trajectory, sequence, i)) placed.push_back({i, *pose});
  }
  return placed;
}

}  // namespace

std::vector<PageFrame> page_sweep(const DepthSequence& sequence, const Trajectory& trajectory,
                                  const std::filesystem::path& path) {
  const std::vector<PosedFrame> placed = posed_frames(sequence, trajectory);
  if (placed.empty()) throw InputError(path.string(), "a frame with a pose in the result", "none");
  const auto width = static_cast<std::size_t>(sequence.camera().width);
  const std::size_t coarser = std::max<std::size_t>(1, (width + shown_width - 1) / shown_width);
  std::vector<PageFrame> sweep;
  for (const Index k : evenly_spread(static_cast<Index>(placed.size()), most_played)) {
    const DepthFrame frame = sequence.read(placed[k].frame);
    sweep.push_back(
        {placed[k].T_world_camera, shown_depth(frame.depth, sequence.camera(), coarser)});
  }
  return sweep;
}

}  // namespace symscene::app
