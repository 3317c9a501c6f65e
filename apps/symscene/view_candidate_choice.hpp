#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "symscene/core/camera.hpp"
#include "symscene/core/scene.hpp"

namespace symscene::app {

/// Of the half sphere of candidates.
struct SphereOptions {
  double radius = 0.0;     ///< [m]; 0: the objects fill the image
  double min_depth = 0.0;  ///< no object is nearer then [m]
};

/// The views that a command chooses from, and the camera that takes them.
struct ViewCandidateChoice {
  std::string candidates = "sphere";  ///< or a file of poses
  std::filesystem::path camera_file;  ///< empty: that of the input
  std::filesystem::path costs;        ///< one number per candidate; empty: none

  void add_to(Arguments& arguments);
  /// The files that are read; some are empty.
  std::vector<std::filesystem::path> files() const;

  /// That of the file, else `of_input`, else of intrinsics.txt in `folder`. Throws InputError if
  /// there is none, or it cannot be read or has no size.
  CameraIntrinsics camera(const std::filesystem::path& folder,
                          const std::optional<CameraIntrinsics>& of_input) const;
  /// T_world_camera of the candidates: those of the file, or views on a half sphere over the
  /// objects. Throws InputError if the file cannot be read or is empty.
  std::vector<Eigen::Isometry3d> poses(const SegmentationResult& result,
                                       const CameraIntrinsics& camera,
                                       const SphereOptions& sphere) const;
  /// Empty without a file. Throws InputError unless it has one number per candidate; "inf" is that
  /// of a view that cannot be reached.
  std::vector<double> read_costs(std::size_t candidates) const;
};

}  // namespace symscene::app
