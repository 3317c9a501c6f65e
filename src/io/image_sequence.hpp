#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "symscene/io/image.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene {

/// The known parameters of the camera of a sequence.
struct Calibration {
  std::optional<CameraIntrinsics> intrinsics;  ///< size 0×0: the size of the images
  std::optional<double> depth_scale;           ///< value of the depth images that is 1 m [1/m]
  std::optional<ImageSize> color_size = {};    ///< none: that of the depth images
};

/// The size of the images of a colour camera of its own; none if colours belong to the depth.
std::optional<ImageSize> own_color_size(const SequenceOptions& options);

/// Combines the given values with the known ones; given values take precedence. Throws InputError,
/// which names the missing options, if one is neither, or if one is not valid.
Calibration resolve_calibration(const std::filesystem::path& path, const std::string& layout,
                                const Calibration& known, const SequenceOptions& given);

/// The files of a frame.
struct ImageFrame {
  double time = 0.0;  ///< [s]
  std::filesystem::path depth;
  std::filesystem::path color;  ///< empty if there is none
  std::optional<Eigen::Isometry3d> T_world_camera;
};

/// The files of a sequence.
struct ImageFrames {
  std::filesystem::path path;
  std::string layout;
  Calibration calibration;
  std::uint16_t invalid = 0;  ///< the value, in addition to 0, of pixels without measurement
  std::vector<ImageFrame> frames;
  std::vector<std::string> warnings = {};
};

/// Makes a sequence of these frames. Colour images of another size than expected are left out with
/// a warning. Throws InputError if there is no frame.
std::unique_ptr<DepthSequence> make_image_sequence(ImageFrames content);

}  // namespace symscene
