#pragma once

#include "symscene/core/options.hpp"

namespace symscene {

/// The truncated signed distance function into which frames are fused.
struct TsdfOptions {
  double voxel_size = 0.0031;
  double voxel_sigmas = 0.4;
  double truncation = 0.0125;
  double max_truncation = 0.04;
  double truncation_sigmas = 3.0;
  double full_weight_behind = 0.25;
  double zero_weight_behind = 0.625;
  double full_weight_sigmas = 1.8;
  double zero_weight_sigmas = 2.85;
  double max_weight = 200.0;
  double max_contradicted_looks = 0.0;
  int max_color_weight = 60;
  double max_memory = 4.0;
  bool color = true;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", between(0.0005, 0.1),
          "least edge of a voxel (section 2.1.1)");
    visit("voxel_sigmas", self.voxel_sigmas, "", between(0.0, 10.0),
          "lower bound of the voxel's edge, in standard deviations of depth at the tenth "
          "percentile of the first frame's depths; truncation distances and the margin of free "
          "space grow with it. 0 for voxel_size at any distance");
    visit("truncation", self.truncation, "m", above_up_to(0.0, 1.0),
          "smallest truncation distance, at least two voxels");
    visit("max_truncation", self.max_truncation, "m", above_up_to(0.0, 1.0),
          "largest truncation distance, for far and noisy depths");
    visit("truncation_sigmas", self.truncation_sigmas, "", above_up_to(0.0, 100.0),
          "truncation distance in standard deviations of a depth");
    visit("full_weight_behind", self.full_weight_behind, "", between(0.0, 1.0),
          "depth behind the surface, as a share of the truncation distance, down to which a "
          "measurement has its full weight (Bylow et al. 2013)");
    visit("zero_weight_behind", self.zero_weight_behind, "", above_up_to(0.0, 1.0),
          "depth behind the surface, as a share of the truncation distance, at which the weight "
          "has fallen to zero (Bylow et al. 2013)");
    visit("full_weight_sigmas", self.full_weight_sigmas, "", between(0.0, 100.0),
          "lower bound of that depth, in standard deviations of a depth; smaller values move far "
          "surfaces back");
    visit("zero_weight_sigmas", self.zero_weight_sigmas, "", above_up_to(0.0, 100.0),
          "lower bound of the depth of zero weight, in standard deviations of a depth");
    visit("max_weight", self.max_weight, "", between(1.0, 250.0),
          "largest weight of a voxel, in frontal views at 1 m");
    visit("max_contradicted_looks", self.max_contradicted_looks, "", between(0.0, 1000.0),
          "weight that a voxel keeps where a frame contradicts it, in weights of that frame: what "
          "was added or taken away is in the surface after about as many frames. 0 keeps all "
          "weight, for scenes at rest");
    visit("max_color_weight", self.max_color_weight, "frames", between(1, 255),
          "largest weight of a voxel's colour");
    visit("max_memory", self.max_memory, "GB", above_up_to(0.0, 1000.0),
          "memory from which the surface is not extended, with a warning");
    visit("color", self.color, "", any_value(), "fuse colours where frames have them");
  }
  /// Throws InputError if a value is out of its range, if the truncation distances are not
  /// 2 voxel_size <= truncation <= max_truncation, or full_weight_behind is not below
  /// zero_weight_behind.
  void validate() const;
};

/// Marching cubes. What counts as seen depends on the fused frames: cells that few
/// frames could have seen need less weight, so that one frame shows all that it measures.
struct SurfaceExtractionOptions {
  double min_looks = 0.6;
  int full_frames = 80;
  int min_triangles = 100;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("min_looks", self.min_looks, "", between(0.0, 2000.0),
          "weight that all corners of a cell need, in those of one frontal frame at the distance "
          "from "
          "which the cell was seen");
    visit("full_frames", self.full_frames, "", at_least(1.0),
          "a cell that this many frames could have seen needs min_looks; with fewer frames the "
          "bound shrinks in proportion");
    visit("min_triangles", self.min_triangles, "", at_least(1.0),
          "smaller connected pieces of the surface are dropped");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
