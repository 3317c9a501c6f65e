#include "core/cell_triangles.hpp"

#include <algorithm>
#include <vector>

namespace symscene {
namespace {

/// A step of the surface's outline over a face of a cell.
struct Segment {
  CellEdge from, to;
};

/// The corners of a face in the order around it, counter-clockwise seen from outside the cell.
std::array<std::uint8_t, 4> face_corners(int axis, int side) {
  const int first = 1 << ((axis + 1) % 3), second = 1 << ((axis + 2) % 3);
  const int base = side << axis;
  std::array<int, 4> around{base, base + first, base + first + second, base + second};
  if (side == 0) std::reverse(around.begin(), around.end());
  std::array<std::uint8_t, 4> corners{};
  for (std::size_t k = 0; k < 4; ++k) corners[k] = static_cast<std::uint8_t>(around[k]);
  return corners;
}

CellEdge edge_between(std::uint8_t a, std::uint8_t b) {
  const int difference = a ^ b;
  return {std::min(a, b), static_cast<std::uint8_t>(difference == 4 ? 2 : difference - 1)};
}

/// Separates each run of corners behind the surface on a face. Two opposite corners are two runs,
/// whatever the neighbouring cell, so both cells separate them in the same way.
void add_face(int behind, int axis, int side, std::vector<Segment>& segments) {
  const auto corners = face_corners(axis, side);
  const auto is_behind = [&](std::size_t k) { return (behind >> corners[k % 4] & 1) != 0; };
  for (std::size_t start = 0; start < 4; ++start) {
    if (!is_behind(start) || is_behind(start + 3)) continue;
    std::size_t end = start;
    while (is_behind(end + 1)) ++end;
    segments.push_back({edge_between(corners[(start + 3) % 4], corners[start]),
                        edge_between(corners[end % 4], corners[(end + 1) % 4])});
  }
}

/// Whether two edges lie on one face of the cell.
bool share_face(const CellEdge& a, const CellEdge& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.axis != axis && b.axis != axis && ((a.corner ^ b.corner) >> axis & 1) == 0) return true;
  }
  return false;
}

/// Rotates an outline so that no diagonal of the fan about its first corner lies in a face of the
/// cell, where the neighbouring cell could have the same diagonal: four triangles at one edge.
/// Every outline has such a corner.
void choose_apex(std::vector<CellEdge>& outline) {
  const auto has_diagonal_in_face = [&] {
    return std::any_of(outline.begin() + 2, outline.end() - 1,
                       [&](const CellEdge& edge) { return share_face(outline[0], edge); });
  };
  for (std::size_t turns = 0; turns < outline.size() && has_diagonal_in_face(); ++turns)
    std::rotate(outline.begin(), outline.begin() + 1, outline.end());
}

/// Joins the segments to closed outlines and fills each with a fan.
CellTriangles fill(std::vector<Segment> segments) {
  CellTriangles cell;
  while (!segments.empty()) {
    std::vector<CellEdge> outline{segments.back().from};
    CellEdge next = segments.back().to;
    segments.pop_back();
    while (next != outline.front()) {
      outline.push_back(next);
      const auto step = std::find_if(segments.begin(), segments.end(),
                                     [&](const Segment& s) { return s.from == next; });
      next = step->to;
      segments.erase(step);
    }
    choose_apex(outline);
    for (std::size_t k = 2; k < outline.size(); ++k) {
      cell.triangles.at(cell.count++) = {outline[0], outline[k - 1], outline[k]};
    }
  }
  return cell;
}

std::array<CellTriangles, 256> make_table() {
  std::array<CellTriangles, 256> table;
  // No surface between corners on one side.
  for (int behind = 1; behind < 255; ++behind) {
    std::vector<Segment> segments;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) add_face(behind, axis, side, segments);
    }
    table[static_cast<std::size_t>(behind)] = fill(std::move(segments));
  }
  return table;
}

}  // namespace

const std::array<CellTriangles, 256>& cell_triangles() {
  static const std::array<CellTriangles, 256> table = make_table();
  return table;
}

}  // namespace symscene
