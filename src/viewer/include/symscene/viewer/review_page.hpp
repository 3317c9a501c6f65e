#pragma once

#include <string>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// A symmetry of a model that a person accepts or rejects, in the frame and unit of the model.
struct ReviewedSymmetry {
  enum class Kind { plane, axis, sphere };

  Kind kind = Kind::plane;
  int order = 0;  ///< of an axis; 0: continuous
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< normal of a plane
  double residual = 0.0;
};

/// The name of a kind on the page and in the file of choices.
const char* to_string(ReviewedSymmetry::Kind kind);

/// A model with its symmetries. One without triangles is shown as points.
struct ReviewedModel {
  std::string name;
  TriangleMesh mesh;
  double millimetres = 1.0;  ///< in a unit of the model
  double diameter = 0.0;
  double diagonal = 0.0;
  std::vector<ReviewedSymmetry> symmetries;
};

/// A self-contained HTML page on which a person reviews the symmetries of models and saves the
/// choices as a file (viewer/README.md). Large meshes are thinned. Throws InputError if a position
/// is not finite.
std::string render_review_page(const std::vector<ReviewedModel>& models, const std::string& title);

}  // namespace symscene
