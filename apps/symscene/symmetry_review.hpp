#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

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
  struct Choice {
    std::string kind;
    Eigen::Vector3d point, direction;
    std::string choice;
    std::optional<int> order;  ///< of an axis, 0 for a continuous one; none where the file has none
  };

  std::map<std::string, std::vector<Choice>> models_;
};

}  // namespace symscene::app
