#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "symscene/io/sequence.hpp"

namespace symscene {

/// What is known of a sequence's camera.
struct Calibration {
  std::optional<CameraIntrinsics> intrinsics;  ///< size 0×0: that of the images
  std::optional<double> depth_scale;           ///< values of the depth images in a metre
};

/// What is given, else what is known.
/// Throws InputError that says what to pass if one is neither, or a given one is no such thing.
Calibration resolve_calibration(const std::filesystem::path& path, const std::string& layout,
                                const Calibration& known, const SequenceOptions& given);

/// A frame as files.
struct ImageFrame {
  double time = 0.0;  ///< [s]
  std::filesystem::path depth;
  std::filesystem::path color;  ///< empty where there is none
  std::optional<Eigen::Isometry3d> T_world_camera;
};

/// A sequence as files.
struct ImageFrames {
  std::filesystem::path path;
  std::string layout;
  Calibration calibration;
  std::uint16_t invalid = 0;  ///< beside 0 the value that stands for nothing measured
  std::vector<ImageFrame> frames;
  std::vector<std::string> warnings = {};
};

/// The sequence of these frames. Colour images of another size than the depth images are left out
/// with a warning. Throws InputError if there is no frame.
std::unique_ptr<DepthSequence> make_image_sequence(ImageFrames content);

}  // namespace symscene
