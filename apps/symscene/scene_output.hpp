#pragma once

#include "arguments.hpp"
#include "session.hpp"
#include "symscene/io/sequence.hpp"
#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/tabletop/scene_building.hpp"

namespace symscene::app {

/// Frames with an estimated pose, and their numbers in the sequence.
struct PlacedFrames {
  Trajectory trajectory;
  std::vector<std::size_t> frames;
};

/// Estimated poses and those of the sequence, for the frames that have both.
struct PosesAndTruth {
  std::vector<Eigen::Isometry3d> poses;
  std::vector<Eigen::Isometry3d> truth;
};
PosesAndTruth poses_and_truth(const DepthSequence& sequence, const PlacedFrames& placed);

/// Throws InputError if a file is in the place of the scene folder, before the work begins.
void require_folder(const std::filesystem::path& output);

/// Where the table of a reconstruction is, as far as the command line tells.
struct TableArguments {
  std::string plane;    ///< a,b,c,d of --plane; empty if it is not given
  bool any_up = false;  ///< accept a table of any orientation

  /// Adds --plane, with this help, and --any-up.
  void add_to(Arguments& arguments, const char* plane_help);

  /// Throws InputError if the text of --plane is not a plane.
  std::optional<Plane> table() const;
};

/// A reconstruction and what it was made from.
struct ReconstructedSequence {
  const Reconstruction& reconstruction;
  const DepthSequence& sequence;
  const PlacedFrames& placed;
  std::string scene_json;  ///< describe_run() of the command
};

/// Makes a scene folder from a reconstruction; shared by reconstruct and stitch.
struct SceneOutput {
  std::filesystem::path input;
  std::filesystem::path output;
  std::optional<Plane> table;  ///< if given
  bool any_up = false;         ///< accept a table of any orientation
  SceneBuildingOptions building;
  SurfaceExtractionOptions extraction;

  /// Extracts the surface, finds the table, and writes the folder, with ground truth if the input
  /// has it. Returns members for the report. Throws InputError if no table or nothing on it is
  /// found.
  std::vector<ReportMember> write(const ReconstructedSequence& made, Session& session,
                                  StageTimer& timer) const;
};

}  // namespace symscene::app
