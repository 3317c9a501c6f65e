#pragma once

#include <array>
#include <cstdint>

namespace symscene {

/// An edge of a cell, from a corner along an axis. Corner k is at (k & 1, k >> 1 & 1, k >> 2).
struct CellEdge {
  std::uint8_t corner = 0;  ///< the end with the lower coordinate
  std::uint8_t axis = 0;

  bool operator==(const CellEdge&) const = default;
};

/// The triangles of a cell as triples of its crossed edges.
struct CellTriangles {
  static constexpr int most = 6;

  std::uint8_t count = 0;
  std::array<std::array<CellEdge, 3>, most> triangles{};
};

/// The triangles of a cell for every set of corners behind the surface (bit k for corner k),
/// counter-clockwise seen from the front.
const std::array<CellTriangles, 256>& cell_triangles();

}  // namespace symscene
