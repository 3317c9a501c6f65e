#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symscene {

/// A node of a regression tree whose nodes are stored depth first: a split, whose lower branch is
/// the next node, or a leaf.
struct TreeNode {
  std::int32_t feature = -1;  ///< index of the feature that is compared; below 0 for a leaf
  std::int32_t upper = 0;     ///< offset from this node to the branch for values above `value`
  float value = 0.0F;         ///< bound of a split, or the log-odds that a leaf adds
};
using Tree = std::vector<TreeNode>;

/// Provenance of a model, one line each; not used in computations.
struct ModelOrigin {
  std::string command;
  std::string date;
  std::string data;
};

/// A probability estimated by gradient-boosted trees (Friedman 2001): the logistic function of a
/// constant plus one leaf per tree. models/README.md documents the file format.
class TreeModel {
 public:
  /// Throws InputError naming `name` if there are no features, a feature's name repeats or is not
  /// one word, a number is not finite, or a tree is not a complete binary tree over these features.
  TreeModel(std::string name, std::vector<std::string> features, float base,
            const std::vector<Tree>& trees, ModelOrigin origin = {});

  const std::string& name() const { return name_; }
  const std::vector<std::string>& features() const { return features_; }
  const ModelOrigin& origin() const { return origin_; }
  /// Log-odds before any tree.
  float base() const { return base_; }
  std::size_t trees() const { return roots_.size(); }
  std::span<const TreeNode> tree(std::size_t index) const;

  /// `values` are the features in order. NaN takes the lower branch of every split. Throws
  /// InputError if their number is not that of the features.
  double probability(std::span<const double> values) const;

  /// Throws InputError naming `where` unless the model has this name and exactly these features.
  void require(const std::string& where, std::string_view name,
               std::span<const std::string> features) const;

 private:
  std::string name_;
  std::vector<std::string> features_;
  ModelOrigin origin_;
  float base_;
  std::vector<std::size_t> roots_;
  std::vector<TreeNode> nodes_;
};

/// The model in a text; `file` is its name in messages. Throws InputError naming file and line if
/// the text is of another version, is truncated or is not a model.
TreeModel parse_tree_model(std::string_view text, const std::string& file);

/// The text of a model; parse_tree_model() restores the same bits.
std::string format_tree_model(const TreeModel& model);

/// A model that replaces an embedded one. Library code reads no files: the caller reads `file` and
/// sets `model`.
struct ModelChoice {
  std::string file;  ///< for messages and configuration files; empty for the embedded model
  std::shared_ptr<const TreeModel> model;  ///< null for the embedded model
};

}  // namespace symscene
