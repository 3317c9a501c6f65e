#include "segmentation/graph_cut.hpp"

#include <random>

#include <gtest/gtest.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

struct Problem {
  std::vector<Affinity> nodes;
  std::vector<WeightedEdge> edges;
};

Problem random_problem(std::uint32_t seed, Index nodes, std::size_t edges) {
  std::mt19937 engine(seed);
  const auto uniform = [&] { return static_cast<float>(engine() % 4096) / 2048.0F; };
  Problem problem;
  for (Index i = 0; i < nodes; ++i) {
    const auto kind = engine() % 3;  // evidence for one side, for the other, or none
    problem.nodes.push_back({kind == 0 ? uniform() : 0.0F, kind == 1 ? uniform() : 0.0F});
  }
  for (std::size_t e = 0; e < edges; ++e) {
    const auto a = static_cast<Index>(engine() % nodes);
    const auto b = static_cast<Index>((a + 1 + engine() % (nodes - 1)) % nodes);
    problem.edges.push_back({a, b, uniform()});
  }
  return problem;
}

double energy_of_labels(const Problem& problem, std::uint32_t labels) {
  double energy = 0.0;
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    energy +=
        double{(labels >> i & 1U) != 0 ? problem.nodes[i].background : problem.nodes[i].object};
  }
  for (const WeightedEdge& edge : problem.edges) {
    if ((labels >> edge.a & 1U) != (labels >> edge.b & 1U)) energy += double{edge.weight};
  }
  return energy;
}

TEST(GraphCut, IsTheLeastOfAllLabellingsOfSmallGraphs) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const Problem problem = random_problem(seed, 10, 5 + seed % 30);
    double least = energy_of_labels(problem, 0);
    for (std::uint32_t labels = 1; labels < 1U << 10U; ++labels) {
      least = std::min(least, energy_of_labels(problem, labels));
    }
    ASSERT_NEAR(cut_graph(problem.nodes, problem.edges).flow, least, 1e-9) << "seed " << seed;
  }
}

TEST(GraphCut, FlowEqualsEnergyExactly) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Problem problem = random_problem(seed, 2000, 8000);
    const GraphCut cut = cut_graph(problem.nodes, problem.edges);
    ASSERT_EQ(cut.flow, labeling_energy(problem.nodes, problem.edges, cut.is_object))
        << "seed " << seed;
  }
}

TEST(GraphCut, FlowEqualsEnergyOnALatticeLikeASurface) {
  constexpr Index side = 150;
  Problem problem = random_problem(7, side * side, 0);
  for (Index y = 0; y < side; ++y) {
    for (Index x = 0; x < side; ++x) {
      const Index i = y * side + x;
      if (x + 1 < side) problem.edges.push_back({i, i + 1, 1.0F + static_cast<float>(i % 7)});
      if (y + 1 < side) problem.edges.push_back({i, i + side, 1.0F + static_cast<float>(i % 5)});
    }
  }
  const GraphCut cut = cut_graph(problem.nodes, problem.edges);
  EXPECT_EQ(cut.flow, labeling_energy(problem.nodes, problem.edges, cut.is_object));
}

TEST(GraphCut, LeavesOutWhatNoEvidenceReaches) {
  // Node 2 stands alone, node 3 hangs on a zero edge: neither has a reason to be object.
  const std::vector<Affinity> nodes{{1.0F, 0.0F}, {0.0F, 0.0F}, {0.0F, 0.0F}, {0.0F, 0.0F}};
  const std::vector<WeightedEdge> edges{{0, 1, 1.0F}, {1, 3, 0.0F}};
  const GraphCut cut = cut_graph(nodes, edges);
  EXPECT_EQ(cut.is_object, (std::vector<std::uint8_t>{1, 1, 0, 0}));
}

TEST(GraphCut, AddsUpRepeatedEdges) {
  const std::vector<Affinity> nodes{{3.0F, 0.0F}, {0.0F, 2.0F}};
  const std::vector<WeightedEdge> edges{{0, 1, 0.5F}, {1, 0, 0.75F}};
  EXPECT_EQ(cut_graph(nodes, edges).flow, 1.25);
}

TEST(GraphCut, OfNothingIsEmpty) { EXPECT_TRUE(cut_graph({}, {}).is_object.empty()); }

TEST(GraphCut, RefusesEdgesToMissingNodesAndBadWeights) {
  const std::vector<Affinity> nodes{{1.0F, 0.0F}, {0.0F, 1.0F}};
  EXPECT_THROW(cut_graph(nodes, std::vector<WeightedEdge>{{0, 2, 1.0F}}), InputError);
  EXPECT_THROW(cut_graph(nodes, std::vector<WeightedEdge>{{0, 1, -1.0F}}), InputError);
  EXPECT_THROW(cut_graph(nodes, std::vector<WeightedEdge>{{0, 1, std::nanf("")}}), InputError);
}

}  // namespace
}  // namespace symscene
