#include "symscene/core/tree_model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// A name stands alone in a line of the file, so it must not be read as another keyword.
bool is_feature_name(const std::string& name) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789_";
  return !name.empty() && name.find_first_not_of(letters) == std::string::npos && name != "leaf" &&
         name != "tree";
}

void check_features(const std::string& where, const std::vector<std::string>& features) {
  if (features.empty()) throw InputError(where, "at least one feature", "none");
  for (std::size_t k = 0; k < features.size(); ++k) {
    if (!is_feature_name(features[k]))
      throw InputError(where, "features named by lower-case words", fmt::format("feature {}", k));
    if (std::find(features.begin(), features.begin() + static_cast<std::ptrdiff_t>(k),
                  features[k]) != features.begin() + static_cast<std::ptrdiff_t>(k))
      throw InputError(where, "distinct features", fmt::format("\"{}\" twice", features[k]));
  }
}

/// Checks that the nodes are one binary tree in depth-first order: then every branch stays within
/// the tree and every path ends at a leaf.
void check_tree(const std::string& where, const Tree& tree, std::size_t features) {
  std::vector<std::size_t> upper_branches;  // of the splits whose lower branch is being read
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const TreeNode& node = tree[k];
    if (!std::isfinite(node.value)) throw InputError(where, "finite numbers", "NaN or infinity");
    if (node.feature >= 0) {
      if (static_cast<std::size_t>(node.feature) >= features)
        throw InputError(where, fmt::format("splits by {} features", features),
                         fmt::format("feature {}", node.feature));
      if (node.upper < 2)
        throw InputError(where, "branches that lie behind their split", "another");
      upper_branches.push_back(k + static_cast<std::size_t>(node.upper));
    } else if (k + 1 < tree.size()) {
      if (upper_branches.empty() || upper_branches.back() != k + 1)
        throw InputError(where, "trees in depth-first order", "another order");
      upper_branches.pop_back();
    }
  }
  if (tree.empty() || tree.back().feature >= 0 || !upper_branches.empty())
    throw InputError(where, "complete trees", "a tree without its last leaf");
}

}  // namespace

TreeModel::TreeModel(std::string name, std::vector<std::string> features, float base,
                     const std::vector<Tree>& trees, ModelOrigin origin)
    : name_(std::move(name)),
      features_(std::move(features)),
      origin_(std::move(origin)),
      base_(base) {
  check_features(name_, features_);
  if (!std::isfinite(base_)) throw InputError(name_, "a finite base", "NaN or infinity");
  for (const Tree& tree : trees) {
    check_tree(name_, tree, features_.size());
    roots_.push_back(nodes_.size());
    nodes_.insert(nodes_.end(), tree.begin(), tree.end());
  }
}

std::span<const TreeNode> TreeModel::tree(std::size_t index) const {
  const std::size_t end = index + 1 < roots_.size() ? roots_[index + 1] : nodes_.size();
  return std::span(nodes_).subspan(roots_[index], end - roots_[index]);
}

double TreeModel::probability(std::span<const double> values) const {
  if (values.size() != features_.size())
    throw InputError(name_, fmt::format("{} features", features_.size()),
                     fmt::format("{}", values.size()));
  double log_odds = double{base_};
  for (const std::size_t root : roots_) {
    const TreeNode* node = &nodes_[root];
    while (node->feature >= 0) {
      const auto value = static_cast<float>(values[static_cast<std::size_t>(node->feature)]);
      node += value > node->value ? node->upper : 1;
    }
    log_odds += double{node->value};
  }
  return 1.0 / (1.0 + std::exp(-log_odds));
}

void TreeModel::require(const std::string& where, std::string_view name,
                        std::span<const std::string> features) const {
  if (name_ != name)
    throw InputError(where, fmt::format("the model {}", name), fmt::format("\"{}\"", name_));
  if (!std::equal(features_.begin(), features_.end(), features.begin(), features.end()))
    throw InputError(where, fmt::format("the features {}", fmt::join(features, " ")),
                     fmt::format("{}", fmt::join(features_, " ")));
}

}  // namespace symscene
