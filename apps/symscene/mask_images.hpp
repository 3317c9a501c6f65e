#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/atomic_file.hpp"
#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/labels/label_image.hpp"

namespace symscene::app {

/// Writes a masks folder (docs/formats.md), frame by frame.
class MaskImageWriter {
 public:
  /// `result` must outlive the writer. Throws InputError if `folder` cannot be written or holds
  /// other files.
  MaskImageWriter(const std::filesystem::path& folder, const SegmentationResult& result,
                  const LabelImageOptions& options);

  /// Labels frame `index` of a sequence and adds its images.
  void add(std::size_t index, const CameraIntrinsics& camera, const DepthFrame& frame,
           const Eigen::Isometry3d& T_scene_camera);

  std::size_t frames() const { return frames_.size(); }

  /// Writes masks.json and gives the folder its name.
  void finish();

 private:
  AtomicDirectory folder_;
  const SegmentationResult& result_;
  PointsInView points_;
  std::vector<PointIndices> masks_;
  std::vector<std::size_t> frames_;
};

}  // namespace symscene::app
