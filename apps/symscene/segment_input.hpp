#pragma once

#include "scene_output.hpp"
#include "symscene/pipeline/pipeline_options.hpp"
#include "symscene/tabletop/cloud_scene.hpp"
#include "symscene/tabletop/view_scene.hpp"

namespace symscene::app {

/// The options of `symscene segment`: of the stages, and of what makes a scene of a single view or
/// of a cloud.
struct SegmentOptions {
  PipelineOptions pipeline;
  ViewSceneOptions view;
  NormalEstimationOptions cloud_normals;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    PipelineOptions::visit_fields(self.pipeline, visit);
    visit("view", self.view);
    visit("cloud_normals", self.cloud_normals);
  }
  void validate() const {
    pipeline.validate();
    view.validate();
    cloud_normals.validate();
  }
};

/// A scene, and what the page shows around its objects.
struct SegmentInput {
  Scene scene;
  TriangleMesh surface;           ///< may be empty
  Trajectory trajectory;          ///< may be empty
  std::vector<StageTime> stages;  ///< wall time of making the scene
};

/// Where `symscene segment` finds its scene.
struct SegmentSource {
  std::filesystem::path path;
  SequenceOptions sequence;
  TableArguments table;

  /// Reads a scene folder, or makes a scene of a cloud or of a sequence of one depth image. Throws
  /// InputError if the path is none of these or cannot be read.
  SegmentInput read(const SegmentOptions& options, Session& session) const;

 private:
  SegmentInput read_folder(Session& session) const;
  SegmentInput read_cloud_file(const SegmentOptions& options, Session& session) const;
  SegmentInput read_view(const SegmentOptions& options, Session& session) const;
};

}  // namespace symscene::app
