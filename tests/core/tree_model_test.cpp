#include "symscene/core/tree_model.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/model_features.hpp"

namespace symscene {
namespace {

constexpr const char* header =
    "symscene_model 1\nname axis\nfitted_by a command\nfitted_on 2026-11-28\nfitted_to data\n"
    "features size rim\nbase -2.5\n";
const std::string two_trees = std::string(header) +
                              "trees 2\n"
                              "tree\n"
                              "  size <= 6.25\n"
                              "    rim <= 0.5\n"
                              "      leaf 1\n"
                              "      leaf 2\n"
                              "    leaf 4\n"
                              "tree\n"
                              "  leaf 0.125\n";

double logistic(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

/// The message with which a text is refused.
std::string refusal(const std::string& text) {
  try {
    parse_tree_model(text, "a.txt");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string with(std::string text, const std::string& old, const std::string& replacement) {
  return text.replace(text.find(old), old.size(), replacement);
}

TEST(TreeModel, AddsOneLeafPerTree) {
  const TreeModel model = parse_tree_model(two_trees, "a.txt");
  const auto of = [&](double size, double rim) { return model.probability(std::array{size, rim}); };
  EXPECT_DOUBLE_EQ(of(6.0, 0.5), logistic(-2.5 + 1.0 + 0.125));  // a bound itself is below
  EXPECT_DOUBLE_EQ(of(6.25, 0.6), logistic(-2.5 + 2.0 + 0.125));
  EXPECT_DOUBLE_EQ(of(6.3, 0.0), logistic(-2.5 + 4.0 + 0.125));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DOUBLE_EQ(of(nan, nan), logistic(-2.5 + 1.0 + 0.125));
  EXPECT_THROW(model.probability(std::array{1.0}), InputError);
}

TEST(TreeModel, KeepsTheTextAndItsBits) {
  const TreeModel model = parse_tree_model(two_trees, "a.txt");
  EXPECT_EQ(format_tree_model(model), two_trees);
  EXPECT_EQ(model.origin().command, "a command");
  EXPECT_EQ(model.origin().date, "2026-11-28");
  EXPECT_EQ(model.origin().data, "data");
  const float third = 1.0F / 3.0F;
  const TreeModel written("thirds", {"x"}, third,
                          {{{0, 2, -third}, {-1, 0, third}, {-1, 0, 1e-30F}}});
  const TreeModel read = parse_tree_model(format_tree_model(written), "a.txt");
  EXPECT_EQ(read.base(), third);
  EXPECT_EQ(read.tree(0)[0].value, -third);
  EXPECT_EQ(read.tree(0)[1].value, third);
  EXPECT_EQ(read.tree(0)[2].value, 1e-30F);
  EXPECT_EQ(read.tree(0)[0].upper, 2);
}

TEST(TreeModel, SkipsCommentsBlankLinesAndCarriageReturns) {
  std::string text = "# a comment\n\n" + two_trees;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.insert(at, "\r");
  EXPECT_EQ(format_tree_model(parse_tree_model(text, "a.txt")), two_trees);
}

TEST(TreeModel, RefusesAnotherVersion) {
  EXPECT_EQ(refusal(with(two_trees, "model 1", "model 2")),
            "a.txt: line 1: expected symscene_model 1, found \"symscene_model 2\"");
  EXPECT_EQ(refusal("{}"), "a.txt: line 1: expected a line \"symscene_model ...\", found \"{}\"");
}

TEST(TreeModel, RefusesEveryTruncation) {
  const std::size_t last = two_trees.rfind("leaf");
  for (std::size_t size = 0; size < last; ++size)
    EXPECT_NE(refusal(two_trees.substr(0, size)), "accepted") << size;
  EXPECT_EQ(refusal(two_trees.substr(0, last)),
            "a.txt: expected a node of a tree, found the end of the file");
}

TEST(TreeModel, RefusesWhatIsNoFiniteNumber) {
  for (const char* value : {"nan", "inf", "-inf", "1e99", "", "1 2", "0x1", "1,5"}) {
    EXPECT_NE(refusal(with(two_trees, "leaf 4", std::string("leaf ") + value)), "accepted")
        << value;
    EXPECT_NE(refusal(with(two_trees, "<= 6.25", std::string("<= ") + value)), "accepted") << value;
    EXPECT_NE(refusal(with(two_trees, "base -2.5", std::string("base ") + value)), "accepted")
        << value;
  }
  EXPECT_EQ(refusal(with(two_trees, "leaf 4", "leaf nan")),
            "a.txt: line 14: expected a finite number, found \"leaf nan\"");
}

TEST(TreeModel, RefusesUnknownFeaturesAndOtherLines) {
  EXPECT_NE(refusal(with(two_trees, "rim <=", "rin <=")).find("line 11"), std::string::npos);
  EXPECT_NE(refusal(with(two_trees, "rim <=", "rim <")), "accepted");
  EXPECT_NE(refusal(with(two_trees, "size rim", "size size")), "accepted");
  EXPECT_NE(refusal(with(two_trees, "features size rim", "features")), "accepted");
  EXPECT_NE(refusal(with(two_trees, "trees 2", "trees 1")), "accepted");
  EXPECT_NE(refusal(with(two_trees, "trees 2", "trees 3")), "accepted");
  EXPECT_NE(refusal(with(two_trees, "trees 2", "trees -2")), "accepted");
  EXPECT_NE(refusal(with(two_trees, "trees 2", "trees 99999999999999999999")), "accepted");
}

TEST(TreeModel, RefusesNodesThatAreNoTree) {
  const TreeNode leaf{-1, 0, 1.0F};
  const std::vector<Tree> wrong = {
      {},                                   // empty
      {{0, 2, 0.0F}, leaf},                 // no upper branch
      {{0, 1, 0.0F}, leaf, leaf},           // the branches are one
      {{0, 0, 0.0F}, leaf, leaf},           // a cycle
      {{0, -1, 0.0F}, leaf, leaf},          // backwards
      {{0, 3, 0.0F}, leaf, leaf},           // out of the tree
      {{0, 2147483647, 0.0F}, leaf, leaf},  // far out of it
      {leaf, leaf},                         // two trees
      {{2, 2, 0.0F}, leaf, leaf},           // an unknown feature
      {{0, 2, 0.0F}, leaf, {-1, 0, std::numeric_limits<float>::quiet_NaN()}},  // not finite
      {{0, 4, 0.0F}, {0, 2, 0.0F}, leaf, leaf, leaf, leaf},  // more leaves than branches
  };
  for (const Tree& tree : wrong)
    EXPECT_THROW(TreeModel("a", {"x", "y"}, 0.0F, {tree}), InputError) << tree.size();
  EXPECT_NO_THROW(TreeModel("a", {"x", "y"}, 0.0F, {{{0, 2, 0.0F}, leaf, leaf}}));
}

TEST(TreeModel, RefusesFeatureNamesThatTheTextCannotHold) {
  for (const char* name : {"", "leaf", "tree", "two words", "<=", "#x", "Size"})
    EXPECT_THROW(TreeModel("a", {name}, 0.0F, {}), InputError) << name;
}

struct SomeFeatures {
  double size = 1.0, rim = 2.0;
  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, Visit&& visit) {
    visit("size", self.size);
    visit("rim", self.rim);
  }
};

struct MoreFeatures {
  double top = 3.0;
  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, Visit&& visit) {
    visit("top", self.top);
  }
};

TEST(ModelFeatures, ComeInTheOrderOfTheirFields) {
  EXPECT_EQ(values_of(SomeFeatures{}, MoreFeatures{}), (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ((names_of<SomeFeatures, MoreFeatures>()),
            (std::vector<std::string>{"size", "rim", "top"}));
}

TEST(ModelFeatures, AreThoseOfTheModel) {
  ModelChoice choice;
  EXPECT_NO_THROW(check_choice<SomeFeatures>(choice, "axis"));  // the embedded one
  choice.file = "a.txt";
  EXPECT_THROW(check_choice<SomeFeatures>(choice, "axis"), InputError);  // not read
  choice.model = std::make_shared<const TreeModel>(parse_tree_model(two_trees, "a.txt"));
  EXPECT_NO_THROW(check_choice<SomeFeatures>(choice, "axis"));
  EXPECT_THROW(check_choice<SomeFeatures>(choice, "plane"), InputError);
  EXPECT_THROW((check_choice<SomeFeatures, MoreFeatures>(choice, "axis")), InputError);
  try {
    check_choice<MoreFeatures>(choice, "axis");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a.txt: expected the features top, found size rim");
  }
}

}  // namespace
}  // namespace symscene
