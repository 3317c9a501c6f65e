#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "result_page.hpp"
#include "segment_input.hpp"
#include "session.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/result.hpp"

namespace symscene::app {

/// Segmented objects, what they were made of, and what the page shows around them.
struct SegmentedInput {
  SegmentationResult result;
  std::optional<Scene> scene;              ///< none if only the result is known
  std::optional<CameraIntrinsics> camera;  ///< of a depth image
  Surroundings around;                     ///< empty without a page
};

/// What a command uses objects for, as its warnings name it.
struct ObjectUse {
  const char* purpose;  ///< that needs closed surfaces: "grasps"
  const char* user;     ///< for which space is free: "the gripper"
};
constexpr ObjectUse grasping_use{"grasps", "the gripper"};
constexpr ObjectUse viewing_use{"views", "lines of sight"};

/// Where a command finds objects: in a result folder, or in a scene, which is segmented with
/// default options.
struct ObjectInput {
  ObjectUse use = grasping_use;
  SegmentSource source = {};
  std::filesystem::path scene = {};  ///< of a result: the scene that it was made of, or empty
  bool with_page = false;

  /// Adds --scene, and the options of a scene that is segmented.
  void add_to(Arguments& arguments, const char* scene_help);
  /// Warns where it is not known which space was never seen. Throws InputError if the input cannot
  /// be read, or `scene` is given for an input that is no result.
  SegmentedInput read(StageTimer& timer, Session& session) const;
  /// What grasps are planned on. Throws InputError if a surface has more than 25 m².
  GraspScene grasp_scene(const SegmentedInput& read, const GraspOptions& options) const;
  /// What is read; some are empty.
  std::vector<std::filesystem::path> paths() const { return {source.path, scene}; }

 private:
  SegmentedInput of_result(StageTimer& timer, Session& session) const;
  SegmentedInput of_scene(StageTimer& timer, Session& session) const;
  void warn_without_occupancy(const std::filesystem::path& path, Session& session) const;
  void warn_of_segmentation(std::span<const std::string> warnings, Session& session) const;
  void warn_without_surfaces(const SegmentationResult& result, Session& session) const;
};

/// Whether a folder is a result.
bool is_result(const std::filesystem::path& path);

}  // namespace symscene::app
