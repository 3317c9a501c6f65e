#pragma once

#include <filesystem>

#include "result_page.hpp"
#include "segment_input.hpp"
#include "session.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/result.hpp"

namespace symscene::app {

/// Segmented objects, as the planner and as the page sees them.
struct SegmentedInput {
  GraspScene scene;
  SegmentationResult result;
  Surroundings around;  ///< empty without a page
};

/// Where a command that grasps finds its objects: in a result folder, or in a scene, which is
/// segmented with default options.
struct GraspInput {
  SegmentSource source;
  std::filesystem::path scene;  ///< of a result: the scene that it was made of, or empty
  bool with_page = false;

  /// Adds --scene, and the options of a scene that is segmented.
  void add_to(Arguments& arguments, const char* scene_help);
  /// Warns where it is not known which space was never seen. Throws InputError if the input cannot
  /// be read, or `scene` is given for an input that is no result.
  SegmentedInput read(StageTimer& timer, Session& session, const GraspOptions& options) const;
  /// Throws InputError if writing `output` would change the input.
  void require_not_input(const std::filesystem::path& output) const;

 private:
  SegmentedInput of_result(StageTimer& timer, Session& session, const GraspOptions& options) const;
  SegmentedInput of_scene(StageTimer& timer, Session& session, const GraspOptions& options) const;
  GraspScene graspable(const SegmentationResult& result, const Scene* around,
                       const GraspOptions& options) const;
  void warn_without_surfaces(const SegmentationResult& result, Session& session) const;
};

/// Whether a folder is a result.
bool is_result(const std::filesystem::path& path);

}  // namespace symscene::app
