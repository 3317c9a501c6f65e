#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "symscene/core/depth_frame.hpp"

namespace symscene {

/// What the files of a sequence do not say. What they do say is used unless it is given here.
struct SequenceOptions {
  std::optional<CameraIntrinsics> intrinsics;  ///< size 0×0: that of the images
  std::optional<double> depth_scale;           ///< values of the depth images in a metre
};

/// A sequence of depth images on disk. Frames are read when they are asked for; no more than one is
/// held. Reading is const and may be done from several threads.
class DepthSequence {
 public:
  virtual ~DepthSequence() = default;

  virtual std::string layout() const = 0;  ///< "sequence", "TUM RGB-D", "7-Scenes", ...
  virtual const CameraIntrinsics& camera() const = 0;
  virtual std::size_t size() const = 0;
  virtual double time(std::size_t i) const = 0;     ///< [s]
  virtual bool has_color() const = 0;               ///< of at least one frame
  virtual bool has_color(std::size_t i) const = 0;  ///< of this one

  /// The frame's pose, where the sequence has one for it. The world is the sequence's own.
  virtual std::optional<Eigen::Isometry3d> pose(std::size_t i) const = 0;

  /// What to doubt about the sequence, such as colour that was left out, a sentence each.
  virtual const std::vector<std::string>& warnings() const = 0;

  /// Throws InputError if the image is not there, cut off, or not of the camera's size.
  virtual DepthFrame read(std::size_t i) const = 0;
};

/// Whether a path looks like a sequence of any layout (docs/formats.md).
bool is_sequence(const std::filesystem::path& path);

/// Opens a sequence in the layout that its path shows: SymScene's own, TUM RGB-D, ICL-NUIM,
/// 7-Scenes or Redwood folders, a ROS 1 bag where the build has a reader of them, one depth image
/// or a folder of them. Throws InputError if it is none, has no frame, or intrinsics or depth scale
/// are neither known nor given; what to pass is then said.
std::unique_ptr<DepthSequence> open_sequence(const std::filesystem::path& path,
                                             const SequenceOptions& options = {});

/// Writes a sequence folder (docs/formats.md) frame by frame; it appears whole under its name when
/// it is finished, and not at all if it is not.
class SequenceWriter {
 public:
  /// Throws InputError if `dir` is neither empty nor a sequence folder, or cannot be written.
  SequenceWriter(const std::filesystem::path& dir, const CameraIntrinsics& camera);
  ~SequenceWriter();
  SequenceWriter(const SequenceWriter&) = delete;
  SequenceWriter& operator=(const SequenceWriter&) = delete;

  /// Depth is rounded to whole millimetres. Either all frames have a pose or none.
  void add(const DepthFrame& frame, const Eigen::Isometry3d* T_world_camera = nullptr);

  /// Puts a file beside the images: table_plane.txt, any name that ends in .json, or
  /// meshes/NAME.ply for the mesh that a truth.json names.
  void add_file(const std::string& name, const std::string& content);

  /// Writes what is left and gives the folder its name. Throws InputError if there is no frame.
  void finish();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
