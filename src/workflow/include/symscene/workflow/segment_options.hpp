#pragma once

#include "symscene/labels/label_image.hpp"
#include "symscene/pipeline/pipeline_options.hpp"
#include "symscene/reconstruction/sensor.hpp"
#include "symscene/tabletop/cloud_scene.hpp"
#include "symscene/tabletop/view_scene.hpp"

namespace symscene {

/// The options of `symscene segment` and `symscene evaluate`: of the stages, and of what makes a
/// scene of a single view or of a cloud, and of label images.
struct SegmentOptions {
  PipelineOptions pipeline;
  ViewSceneOptions view;
  NormalEstimationOptions cloud_normals;
  LabelImageOptions masks;
  SensorEstimationOptions sensor;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    PipelineOptions::visit_fields(self.pipeline, visit);
    visit("view", self.view);
    visit("cloud_normals", self.cloud_normals);
    visit("masks", self.masks);
    visit("sensor", self.sensor);
  }
  void validate() const {
    pipeline.validate();
    view.validate();
    cloud_normals.validate();
    masks.validate();
    sensor.validate();
  }
};

}  // namespace symscene
