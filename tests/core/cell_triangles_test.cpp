#include "core/cell_triangles.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include <Eigen/Geometry>

namespace symscene {
namespace {

using Edge = std::pair<int, int>;     // corner, axis
using Step = std::pair<Edge, Edge>;   // along a triangle
using Steps = std::map<Step, int>;    // how often it is taken
using Corners = std::array<Edge, 3>;  // of a triangle

Edge as_pair(const CellEdge& edge) { return {edge.corner, edge.axis}; }

std::vector<Corners> triangles_of(int behind) {
  const CellTriangles& cell = cell_triangles()[static_cast<std::size_t>(behind)];
  std::vector<Corners> triangles;
  for (std::size_t k = 0; k < cell.count; ++k) {
    const auto& t = cell.triangles[k];
    triangles.push_back({as_pair(t[0]), as_pair(t[1]), as_pair(t[2])});
  }
  return triangles;
}

bool is_behind(int behind, int corner) { return (behind >> corner & 1) != 0; }

bool crosses(int behind, const Edge& edge) {
  return is_behind(behind, edge.first) != is_behind(behind, edge.first | 1 << edge.second);
}

std::set<Edge> crossed_edges(int behind) {
  std::set<Edge> edges;
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) == 0 && crosses(behind, {corner, axis}))
        edges.insert({corner, axis});
    }
  }
  return edges;
}

Steps steps_of(int behind) {
  Steps steps;
  for (const Corners& t : triangles_of(behind)) {
    for (std::size_t c = 0; c < 3; ++c) ++steps[{t[c], t[(c + 1) % 3]}];
  }
  return steps;
}

/// The directed edges without an opposite: the outline of the cell's surface.
std::set<Step> outline_of(int behind) {
  const Steps steps = steps_of(behind);
  std::set<Step> outline;
  for (const auto& [step, count] : steps) {
    if (!steps.contains({step.second, step.first})) outline.insert(step);
  }
  return outline;
}

bool on_face(const Edge& edge, int axis, int side) {
  return edge.second != axis && (edge.first >> axis & 1) == side;
}

Eigen::Vector3d middle(const Edge& edge) {
  Eigen::Vector3d p(edge.first & 1, edge.first >> 1 & 1, edge.first >> 2 & 1);
  p[edge.second] += 0.5;
  return p;
}

TEST(CellTriangles, HaveTheirCornersOnExactlyTheCrossedEdges) {
  for (int behind = 0; behind < 256; ++behind) {
    std::set<Edge> used;
    for (const Corners& t : triangles_of(behind)) {
      used.insert(t.begin(), t.end());
      EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) << behind;
    }
    EXPECT_EQ(used, crossed_edges(behind)) << behind;
  }
}

TEST(CellTriangles, UseNoDirectedEdgeTwiceAndEndOnlyOnFacesOfTheCell) {
  for (int behind = 0; behind < 256; ++behind) {
    for (const auto& [step, count] : steps_of(behind)) EXPECT_EQ(count, 1) << behind;
    for (const Step& step : outline_of(behind)) {
      int faces = 0;
      for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
          faces += on_face(step.first, axis, side) && on_face(step.second, axis, side) ? 1 : 0;
        }
      }
      EXPECT_EQ(faces, 1) << behind;
    }
  }
}

TEST(CellTriangles, HaveClosedOutlines) {
  for (int behind = 0; behind < 256; ++behind) {
    std::map<Edge, int> out, in;
    for (const Step& step : outline_of(behind)) {
      ++out[step.first];
      ++in[step.second];
    }
    EXPECT_EQ(out, in) << behind;
    for (const auto& [edge, count] : out) EXPECT_EQ(count, 1) << behind;
  }
}

/// A diagonal in a face could be one of the neighbouring cell too: an edge of four triangles.
TEST(CellTriangles, HaveNoDiagonalInAFaceOfTheCell) {
  for (int behind = 0; behind < 256; ++behind) {
    const std::set<Step> outline = outline_of(behind);
    for (const auto& [step, count] : steps_of(behind)) {
      if (outline.contains(step)) continue;
      for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
          EXPECT_FALSE(on_face(step.first, axis, side) && on_face(step.second, axis, side))
              << behind;
        }
      }
    }
  }
}

TEST(CellTriangles, AreCounterClockwiseSeenFromTheFront) {
  for (int corner = 0; corner < 8; ++corner) {
    const auto one = triangles_of(1 << corner);
    ASSERT_EQ(one.size(), 1U);
    const Eigen::Vector3d a = middle(one[0][0]), b = middle(one[0][1]), c = middle(one[0][2]);
    const Eigen::Vector3d behind(corner & 1, corner >> 1 & 1, corner >> 2);
    EXPECT_LT((b - a).cross(c - a).dot(behind - a), 0.0) << corner;
  }
}

TEST(CellTriangles, ReverseWhenInsideAndOutsideSwap) {
  // A face without ambiguity is cut alike from both sides: what is before and behind may be
  // swapped.
  for (const int behind : {1, 3, 7, 15, 51, 23}) {
    std::set<Step> back;
    for (const Step& step : outline_of(255 - behind)) back.insert({step.second, step.first});
    EXPECT_EQ(outline_of(behind), back) << behind;
  }
}

/// The outline on one face, edges being named by where they are on it.
std::set<Step> outline_on(int behind, int axis, int side) {
  std::set<Step> steps;
  const auto flat = [&](Edge edge) { return Edge{edge.first & ~(1 << axis), edge.second}; };
  for (const Step& step : outline_of(behind)) {
    if (on_face(step.first, axis, side) && on_face(step.second, axis, side)) {
      steps.insert({flat(step.first), flat(step.second)});
    }
  }
  return steps;
}

/// Signs of two cells that share a face: those of the second follow from the first on it.
TEST(CellTriangles, OfNeighboursMeetWithoutCracks) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int first = 0; first < 256; ++first) {
      std::mt19937 random(static_cast<unsigned>(256 * axis + first));
      for (int trial = 0; trial < 16; ++trial) {
        int second = static_cast<int>(random() & 255U);
        for (int corner = 0; corner < 8; ++corner) {
          if ((corner >> axis & 1) != 0) continue;
          const int shared = is_behind(first, corner | 1 << axis) ? 1 : 0;
          second = (second & ~(1 << corner)) | shared << corner;
        }
        std::set<Step> back;
        for (const Step& step : outline_on(second, axis, 0)) back.insert({step.second, step.first});
        EXPECT_EQ(outline_on(first, axis, 1), back) << first << " and " << second;
      }
    }
  }
}

}  // namespace
}  // namespace symscene
