#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "symmetry/symmetry_score.hpp"
#include "symscene/core/tree_model.hpp"

/// The fitted models know objects of the size of household ones: some of their features are
/// lengths. For scaled objects their bounds are scaled.
namespace symscene::testing {

/// `model` with the bounds of the features in `lengths` multiplied by `scale`.
inline ModelChoice scaled_model(const TreeModel& model, const std::vector<std::string>& lengths,
                                double scale) {
  std::vector<bool> is_length;
  for (const std::string& feature : model.features())
    is_length.push_back(std::find(lengths.begin(), lengths.end(), feature) != lengths.end());
  std::vector<Tree> trees;
  for (std::size_t k = 0; k < model.trees(); ++k) {
    Tree& tree = trees.emplace_back(model.tree(k).begin(), model.tree(k).end());
    for (TreeNode& node : tree) {
      if (node.feature >= 0 && is_length[static_cast<std::size_t>(node.feature)])
        node.value *= static_cast<float>(scale);
    }
  }
  return {"", std::make_shared<TreeModel>(model.name(), model.features(), model.base(), trees)};
}

inline ModelChoice scaled_axis_model(double scale) {
  return scaled_model(axis_model(), {"residual", "height", "radius"}, scale);
}
inline ModelChoice scaled_plane_model(double scale) {
  return scaled_model(plane_model(), {"residual", "extent", "length", "thickness"}, scale);
}

}  // namespace symscene::testing
