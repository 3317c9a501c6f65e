#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// What a person chose for a symmetry of a model on the review page.
struct ReviewChoice {
  static constexpr int continuous = 0;  ///< as an order: any angle

  std::string kind;           ///< "plane", "axis" or "sphere"
  Eigen::Vector3d point;      ///< in the frame and unit of the model
  Eigen::Vector3d direction;  ///< unit; the normal of a plane
  std::string choice;         ///< "accepted", "rejected" or "open"
  std::optional<int> order;   ///< of an axis; none where the file has none
};

/// The choices of each model by its name.
using ReviewChoicesByModel = std::map<std::string, std::vector<ReviewChoice>>;

/// Parses a file that the review page saved (docs/formats.md, Choices of a review). Throws
/// InputError, with the name of the file, if it is none.
ReviewChoicesByModel parse_review_choices(std::string_view text, const std::string& name);

}  // namespace symscene
