#pragma once

#include "arguments.hpp"
#include "session.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/sequence.hpp"
#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/tabletop/scene_building.hpp"
#include "symscene/workflow/known_table.hpp"
#include "workflow/plane_fallback.hpp"

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
  bool none = false;    ///< there is no table

  /// Adds --plane, with this help, --any-up and --no-table.
  void add_to(Arguments& arguments, const char* plane_help);

  /// Throws InputError if the text of --plane is not a plane, or if two of the options are given.
  std::optional<Plane> table() const;

  /// Whether the command line tells where the table is, or that there is none.
  bool is_told() const { return none || !plane.empty(); }

  /// One of the options that is given; nullptr if none is.
  const char* given() const {
    if (!plane.empty()) return "--plane";
    if (none) return "--no-table";
    return any_up ? "--any-up" : nullptr;
  }

  /// What the command line tells. Throws as table().
  KnownTable told() const { return {table(), none, any_up}; }

  /// What is known about the table, from the command line and the cameras.
  TablePrior known(TablePrior from_cameras) const { return told().with(std::move(from_cameras)); }
};

/// What a scene folder is made from.
struct SceneSource {
  const DepthSequence& sequence;
  const PlacedFrames& placed;
  std::string scene_json;  ///< describe_run() of the command
};

/// What a scene folder holds.
struct SceneContent {
  const BuiltScene& built;
  const OccupancyVolume& occupancy;
  const TriangleMesh& surface;
};

/// Makes a scene folder; shared by reconstruct and stitch.
struct SceneOutput {
  std::filesystem::path input;
  std::filesystem::path output;
  TableArguments table;
  SceneBuildingOptions building;

  /// Extracts the surface, finds the table, and writes the folder.
  std::vector<ReportMember> write(const Reconstruction& reconstruction,
                                  const SurfaceExtractionOptions& extraction,
                                  const SceneSource& source, Session& session,
                                  StageTimer& timer) const;

  /// Writes the folder, with ground truth if the input has it. Returns members for the report.
  std::vector<ReportMember> write(const SceneContent& content, const SceneSource& source,
                                  Session& session, StageTimer& timer) const;
};

/// Prints the table that was found.
void print_table(const BuiltScene& built, Session& session);

/// Prints the table that was found and the warnings of the scene.
void report_table(const BuiltScene& built, Session& session);

}  // namespace symscene::app
