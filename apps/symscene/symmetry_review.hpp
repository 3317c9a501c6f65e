#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/review_choices.hpp"
#include "symmetry_formats.hpp"
#include "symscene/core/triangle_mesh.hpp"
#include "symscene/viewer/review_page.hpp"

namespace symscene::app {

/// A model as the review page shows it.
ReviewedModel reviewed_model(const ModelSymmetries& symmetries, TriangleMesh mesh);

/// The choices that a person saved on the review page.
class ReviewChoices {
 public:
  /// Throws InputError if the file cannot be read.
  explicit ReviewChoices(const std::filesystem::path& file);

  /// Removes what was rejected from a model's group. Returns a sentence for each symmetry that is
  /// left out with it, and for what was not reviewed.
  std::vector<std::string> apply(ModelSymmetries& model) const;

 private:
  ReviewChoicesByModel models_;
};

}  // namespace symscene::app
