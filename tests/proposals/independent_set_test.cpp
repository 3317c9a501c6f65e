#include "proposals/independent_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "surfaces.hpp"

namespace symscene {
namespace {

void connect(ConflictGraph& graph, std::size_t a, std::size_t b) {
  graph.adjacency[a].push_back(b);
  graph.adjacency[b].push_back(a);
  std::sort(graph.adjacency[a].begin(), graph.adjacency[a].end());
  std::sort(graph.adjacency[b].begin(), graph.adjacency[b].end());
}

ConflictGraph random_graph(Random& random, std::size_t nodes, double density) {
  ConflictGraph graph;
  graph.adjacency.resize(nodes);
  for (std::size_t a = 0; a < nodes; ++a) {
    graph.weights.push_back(random.uniform(0.1, 1.0));
    for (std::size_t b = 0; b < a; ++b) {
      if (random.chance(density)) connect(graph, a, b);
    }
  }
  return graph;
}

bool is_independent(const ConflictGraph& graph, const std::vector<bool>& chosen) {
  for (std::size_t a = 0; a < chosen.size(); ++a) {
    for (const std::size_t b : graph.adjacency[a]) {
      if (chosen[a] && chosen[b]) return false;
    }
  }
  return true;
}

double weight(const ConflictGraph& graph, const std::vector<bool>& chosen) {
  double sum = 0.0;
  for (std::size_t a = 0; a < chosen.size(); ++a) sum += chosen[a] ? graph.weights[a] : 0.0;
  return sum;
}

double brute_force(const ConflictGraph& graph) {
  double best = 0.0;
  for (unsigned set = 0; set < 1U << graph.weights.size(); ++set) {
    std::vector<bool> chosen;
    for (std::size_t a = 0; a < graph.weights.size(); ++a) chosen.push_back((set >> a & 1U) != 0);
    if (is_independent(graph, chosen)) best = std::max(best, weight(graph, chosen));
  }
  return best;
}

TEST(IndependentSet, IsExactUpToTheGivenSize) {
  for (const std::uint32_t seed : testing::seeds) {
    Random random(seed);
    const ConflictGraph graph = random_graph(random, 10, 0.3);
    const std::vector<bool> chosen = max_weight_independent_set(graph, 10);
    EXPECT_TRUE(is_independent(graph, chosen));
    EXPECT_NEAR(weight(graph, chosen), brute_force(graph), 1e-12) << "seed " << seed;
  }
}

TEST(IndependentSet, BySearchIsIndependentAndMaximal) {
  for (const std::uint32_t seed : testing::seeds) {
    Random random(seed);
    const ConflictGraph graph = random_graph(random, 60, 0.1);
    std::vector<bool> chosen = max_weight_independent_set(graph, 1);
    EXPECT_TRUE(is_independent(graph, chosen));
    for (std::size_t a = 0; a < chosen.size(); ++a) {
      if (chosen[a]) continue;
      chosen[a] = true;
      EXPECT_FALSE(is_independent(graph, chosen)) << "node " << a << " could be added";
      chosen[a] = false;
    }
  }
}

TEST(IndependentSet, BySearchIsNoHeavierThanTheExactOneAndNoLighterThanAnyNode) {
  for (const std::uint32_t seed : testing::seeds) {
    Random random(seed);
    const ConflictGraph graph = random_graph(random, 12, 0.3);
    const double found = weight(graph, max_weight_independent_set(graph, 1));
    EXPECT_LE(found, weight(graph, max_weight_independent_set(graph, 12)) + 1e-12);
    EXPECT_GE(found, *std::max_element(graph.weights.begin(), graph.weights.end()) - 1e-12);
  }
}

TEST(IndependentSet, SwapsAHeavyNodeForItsNeighbours) {
  ConflictGraph star;  // greedy takes the centre
  star.weights = {1.0, 0.6, 0.6};
  star.adjacency.resize(3);
  connect(star, 0, 1);
  connect(star, 0, 2);
  EXPECT_EQ(max_weight_independent_set(star, 1), (std::vector<bool>{false, true, true}));
  EXPECT_EQ(max_weight_independent_set(star, 3), (std::vector<bool>{false, true, true}));
}

TEST(IndependentSet, OfNoConflictsIsEveryNode) {
  ConflictGraph graph;
  graph.weights = {0.5, 0.1};
  graph.adjacency.resize(2);
  EXPECT_EQ(max_weight_independent_set(graph, 1), (std::vector<bool>{true, true}));
  EXPECT_TRUE(max_weight_independent_set({}, 1).empty());
}

}  // namespace
}  // namespace symscene
