#pragma once

#include "symscene/pipeline/pipeline_options.hpp"
#include "symscene/workflow/object_identities.hpp"
#include "symscene/workflow/tracked_scene_options.hpp"

namespace symscene {

/// The options of a scene that is segmented while its frames arrive. Those of the reconstruction
/// differ from its defaults, because objects come and go: what a frame contradicts is forgotten,
/// and the camera is not taken for lost where a part of the image has changed.
struct LiveOptions {
  LiveOptions();

  TrackedSceneOptions tracked;
  PipelineOptions pipeline;
  ObjectIdentityOptions identity;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    TrackedSceneOptions::visit_fields(self.tracked, visit);
    PipelineOptions::visit_fields(self.pipeline, visit);
    visit("identity", self.identity);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const {
    tracked.validate();
    pipeline.validate();
    identity.validate();
  }
};

}  // namespace symscene
