#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "moved_mesh.hpp"
#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene::bench {

/// The planes and axes that a person saw in a scanned model.
struct AnnotatedModel {
  std::string number;  ///< with which the model's name begins
  std::vector<Eigen::Vector3d> normals, directions;
};

/// A file of blocks of five lines: an offset, three normals of planes and a direction of an axis,
/// zeros where there is none. Its blocks are those of 20 objects of the YCB set in their order; a
/// 21st, of 011, is wrong and left out. Throws InputError on another number of lines.
std::vector<AnnotatedModel> read_annotated_models(const std::filesystem::path& path);

/// Annotated symmetries against those that are found.
struct AnnotationCounts {
  int all = 0;
  int near_angle = 0;         ///< a found one is within 1°
  int near = 0;               ///< and within 1 % of the diagonal
  int annotation_better = 0;  ///< the annotated one has the smaller residual
};

/// Compares one model, and returns a line per annotated symmetry: angle and distance of the nearest
/// found one, and the exact residuals of both. Annotated ones go through the centroid; residuals of
/// annotated planes are those at the best distance from it.
std::string compare_with_annotation(const AnnotatedModel& annotated, const std::string& name,
                                    const MovedMesh& mesh, const SymmetryGroup& group,
                                    AnnotationCounts& counts);

}  // namespace symscene::bench
