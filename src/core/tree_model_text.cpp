#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/number_in.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/tree_model.hpp"

namespace symscene {
namespace {

constexpr std::string_view magic = "symscene_model";
constexpr int version = 1;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// The first word of a line and what follows it.
std::pair<std::string_view, std::string_view> split_word(std::string_view line) {
  const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  return {line.substr(0, end), trimmed(line.substr(end))};
}

/// Reads the lines of a model's text in order; blank lines and those that begin with # are skipped.
class ModelReader {
 public:
  ModelReader(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  TreeModel read() {
    const auto found = number_in<int>(field(magic));
    if (found != version) refuse(fmt::format("{} {}", magic, version), line_);
    std::string name(field("name"));
    ModelOrigin origin;
    origin.command = field("fitted_by");
    origin.date = field("fitted_on");
    origin.data = field("fitted_to");
    read_features();
    const float base = finite(field("base"));
    const auto count = number_in<std::size_t>(field("trees"));
    if (!count) refuse("the number of trees", line_);
    std::vector<Tree> trees;
    while (trees.size() < *count) trees.push_back(read_tree());
    if (next_line()) refuse(fmt::format("the end after {} trees", *count), line_);
    try {
      return {std::move(name), std::move(features_), base, trees, std::move(origin)};
    } catch (const InputError& error) {
      throw InputError(file_, error.expected(), error.found());
    }
  }

 private:
  bool next_line() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      line_ = trimmed(rest_.substr(0, end));
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++number_;
      if (!line_.empty() && line_.front() != '#') return true;
    }
    return false;
  }

  [[noreturn]] void refuse(const std::string& expected, std::string_view found) const {
    constexpr std::size_t most = 60;
    throw InputError(fmt::format("{}: line {}", file_, number_), expected,
                     fmt::format("\"{}\"", found.substr(0, most)));
  }

  void require_line(const std::string& expected) {
    if (!next_line()) throw InputError(file_, expected, "the end of the file");
  }

  /// What follows a keyword on the next line.
  std::string_view field(std::string_view keyword) {
    require_line(fmt::format("a line \"{} ...\"", keyword));
    const auto [word, value] = split_word(line_);
    if (word != keyword) refuse(fmt::format("a line \"{} ...\"", keyword), line_);
    return value;
  }

  float finite(std::string_view word) const {
    const auto value = number_in<float>(word);
    if (!value || !std::isfinite(*value)) refuse("a finite number", line_);
    return *value;
  }

  void read_features() {
    std::string_view names = field("features");
    while (!names.empty()) {
      const auto [name, rest] = split_word(names);
      index_.emplace(name, static_cast<std::int32_t>(features_.size()));
      features_.emplace_back(name);
      names = rest;
    }
  }

  /// A split or a leaf: "FEATURE <= BOUND" or "leaf VALUE".
  TreeNode read_node() {
    require_line("a node of a tree");
    const auto [word, rest] = split_word(line_);
    if (word == "leaf") return {-1, 0, finite(rest)};
    const auto feature = index_.find(word);
    const auto [relation, bound] = split_word(rest);
    if (feature == index_.end() || relation != "<=")
      refuse("\"leaf VALUE\" or \"FEATURE <= BOUND\" with one of the features", line_);
    return {feature->second, 0, finite(bound)};
  }

  /// Depth first: the lower branch of a split follows it, then its upper branch.
  Tree read_tree() {
    if (!field("tree").empty()) refuse("a line \"tree\"", line_);
    Tree tree;
    std::vector<std::size_t> open;  // splits whose upper branch is to come
    while (true) {
      tree.push_back(read_node());
      if (tree.back().feature >= 0) {
        open.push_back(tree.size() - 1);
        continue;
      }
      if (open.empty()) return tree;
      tree[open.back()].upper = static_cast<std::int32_t>(tree.size() - open.back());
      open.pop_back();
    }
  }

  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
  const std::string& file_;
  std::vector<std::string> features_;
  std::unordered_map<std::string_view, std::int32_t> index_;
};

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// Appends a tree, each node indented by its depth.
void append_tree(const TreeModel& model, std::span<const TreeNode> tree, std::string& text) {
  text += "tree\n";
  std::vector<std::size_t> depths{1};  // of the branches to come
  for (const TreeNode& node : tree) {
    const std::size_t depth = depths.back();
    depths.pop_back();
    text.append(2 * depth, ' ');
    if (node.feature < 0) {
      text += fmt::format("leaf {:.9g}\n", node.value);
      continue;
    }
    text += fmt::format("{} <= {:.9g}\n", model.features()[static_cast<std::size_t>(node.feature)],
                        node.value);
    depths.insert(depths.end(), 2, depth + 1);
  }
}

}  // namespace

TreeModel parse_tree_model(std::string_view text, const std::string& file) {
  return ModelReader(text, file).read();
}

std::string format_tree_model(const TreeModel& model) {
  const ModelOrigin& origin = model.origin();
  std::string text = fmt::format(
      "{} {}\nname {}\nfitted_by {}\nfitted_on {}\nfitted_to {}\nfeatures {}\nbase {:.9g}\n"
      "trees {}\n",
      magic, version, one_line(model.name()), one_line(origin.command), one_line(origin.date),
      one_line(origin.data), fmt::join(model.features(), " "), model.base(), model.trees());
  for (std::size_t k = 0; k < model.trees(); ++k) append_tree(model, model.tree(k), text);
  return text;
}

}  // namespace symscene
