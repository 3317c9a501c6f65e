#pragma once

#include "session.hpp"
#include "symscene/io/sequence.hpp"
#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/tabletop/scene_building.hpp"

namespace symscene::app {

/// Frames that could be placed, by their numbers in the sequence.
struct PlacedFrames {
  Trajectory trajectory;
  std::vector<std::size_t> frames;
};

/// Where placed frames are, and where the sequence says that they are; frames without either left
/// out.
struct PosesAndTruth {
  std::vector<Eigen::Isometry3d> poses;
  std::vector<Eigen::Isometry3d> truth;
};
PosesAndTruth poses_and_truth(const DepthSequence& sequence, const PlacedFrames& placed);

/// Throws InputError if a scene folder cannot be written because a file is in its place: before the
/// work, not after it.
void require_folder(const std::filesystem::path& output);

/// The table of --plane a,b,c,d; none where that is empty. Throws InputError if it is no plane.
std::optional<Plane> plane_option(const std::string& text);

/// The half of a subcommand that makes a scene folder of a reconstruction.
struct SceneOutput {
  std::filesystem::path input;
  std::filesystem::path output;
  std::optional<Plane> table;  ///< where it is given
  bool any_up = false;         ///< the table may face anywhere
  SceneBuildingOptions building;

  /// Extracts the surface, finds the table, writes the folder with what is known of the truth and
  /// says what there is. Returns members for the report. Throws InputError if nothing stands on a
  /// table.
  std::vector<ReportMember> write(const Reconstruction& reconstruction,
                                  const SurfaceExtractionOptions& extraction,
                                  const DepthSequence& sequence, const PlacedFrames& placed,
                                  const std::string& scene_json, Session& session,
                                  StageTimer& timer) const;
};

}  // namespace symscene::app
