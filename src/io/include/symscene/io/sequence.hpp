#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "symscene/core/camera_model.hpp"
#include "symscene/core/depth_frame.hpp"

namespace symscene {

/// The camera of a sequence, for layouts whose files do not give it. Values here take precedence
/// over those of the files.
struct SequenceOptions {
  std::optional<CameraIntrinsics> intrinsics;  ///< size 0×0: the size of the images
  std::optional<double> depth_scale;           ///< value of the depth images that is 1 m [1/m]
  /// A calibrated camera, in place of `intrinsics`: frames are read rectified.
  std::optional<CameraModel> camera = {};
};

/// A sequence of depth images on disk. Frames are read on demand and not kept. Reading is const and
/// may be done from several threads.
class DepthSequence {
 public:
  virtual ~DepthSequence() = default;

  virtual std::string layout() const = 0;              ///< "sequence", "TUM RGB-D", "7-Scenes", ...
  virtual const CameraIntrinsics& camera() const = 0;  ///< of the frames as they are read
  /// The value of the depth images that is 1 m, of the files or as it was given. [1/m]
  virtual double depth_scale() const = 0;
  virtual std::size_t size() const = 0;
  virtual double time(std::size_t i) const = 0;     ///< [s]
  virtual bool has_color() const = 0;               ///< whether any frame has colour
  virtual bool has_color(std::size_t i) const = 0;  ///< whether frame i has colour

  /// The pose of frame i in the world frame of the sequence, if it is known.
  virtual std::optional<Eigen::Isometry3d> pose(std::size_t i) const = 0;

  /// Limitations of the sequence, such as colour that was left out, one sentence each.
  virtual const std::vector<std::string>& warnings() const = 0;

  /// Throws InputError if an image is missing, truncated, or not of the camera's size.
  virtual DepthFrame read(std::size_t i) const = 0;
};

/// Whether a path looks like a sequence of any layout (docs/formats.md).
bool is_sequence(const std::filesystem::path& path);

/// Opens a sequence in the layout that its path shows: SymScene's own, TUM RGB-D, ICL-NUIM,
/// 7-Scenes or Redwood folders, a recording of ROS (a ROS 1 bag, an MCAP file, a .db3 file or
/// folder of rosbag2) where the build has a reader of it, one depth image or a folder of them.
/// Throws InputError if it is none of these, has no frame, intrinsics or depth scale are neither in
/// the files nor in `options` (the message names the missing options), the principal point is
/// outside the image, or a calibrated camera is not valid.
std::unique_ptr<DepthSequence> open_sequence(const std::filesystem::path& path,
                                             const SequenceOptions& options = {});

/// Writes a sequence folder (docs/formats.md) frame by frame. The folder appears, complete, under
/// its name when finish() is called, and not at all otherwise.
class SequenceWriter {
 public:
  /// Throws InputError if `dir` is neither empty nor a sequence folder, or cannot be written.
  SequenceWriter(const std::filesystem::path& dir, const CameraIntrinsics& camera);
  ~SequenceWriter();
  SequenceWriter(const SequenceWriter&) = delete;
  SequenceWriter& operator=(const SequenceWriter&) = delete;

  /// Depth is rounded to whole millimetres. Either all frames have a pose or none has.
  /// Throws InputError if times decrease or the frame is not of the camera's size.
  void add(const DepthFrame& frame, const Eigen::Isometry3d* T_world_camera = nullptr);

  /// Adds a file: table_plane.txt, any name that ends in .json, or meshes/NAME.ply for a mesh that
  /// truth.json refers to. Throws InputError for other names.
  void add_file(const std::string& name, const std::string& content);

  /// Writes the remaining files and gives the folder its name. Throws InputError if there is no
  /// frame.
  void finish();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
