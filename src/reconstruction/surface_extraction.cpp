#include "symscene/reconstruction/surface_extraction.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "cell_triangles.hpp"
#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr int edge = TsdfBlock::edge;
constexpr int margin = 1;                      // voxels of the neighbours before a block
constexpr int padded = edge + 2 * margin + 1;  // and two behind it

/// The field of a block and of the voxels around it. [units]
struct PaddedField {
  std::array<float, padded * padded * padded> distance;
  std::array<std::uint16_t, padded * padded * padded> weight;

  static constexpr int stride[3] = {1, padded, padded* padded};
  static int at(int x, int y, int z) {
    return ((z + margin) * padded + y + margin) * padded + x + margin;
  }
};

void read_field(const TsdfVolume& volume, const Eigen::Vector3i& block, PaddedField& field) {
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const std::int32_t slot = volume.index().find(block + Eigen::Vector3i(x, y, z));
        const TsdfBlock* source =
            slot == BlockIndex::none ? nullptr : &volume.block(static_cast<std::size_t>(slot));
        const auto begin = [](int side) { return side < 0 ? -margin : side * edge; };
        const auto end = [](int side) { return side < 0 ? 0 : side == 0 ? edge : edge + 2; };
        for (int k = begin(z); k < end(z); ++k) {
          for (int j = begin(y); j < end(y); ++j) {
            for (int i = begin(x); i < end(x); ++i) {
              const auto to = static_cast<std::size_t>(PaddedField::at(i, j, k));
              const auto from = static_cast<std::size_t>(((k & 7) << 6) | ((j & 7) << 3) | (i & 7));
              field.distance[to] = source ? static_cast<float>(source->distance[from]) : 0.0F;
              field.weight[to] = source ? source->weight[from] : std::uint16_t{0};
            }
          }
        }
      }
    }
  }
}

/// Which edges of a block's voxels carry a vertex, and the number of those before each word.
struct BlockVertices {
  static constexpr std::size_t edges = 3 * TsdfBlock::voxels;

  std::array<std::uint64_t, edges / 64> crossed{};
  std::array<std::uint16_t, edges / 64> before{};
  std::uint32_t first = 0;  ///< number of the block's first vertex
  std::uint32_t count = 0;

  static std::size_t bit(int voxel, int axis) { return static_cast<std::size_t>(3 * voxel + axis); }
  void set(std::size_t b) { crossed[b / 64] |= std::uint64_t{1} << (b % 64); }
  void number() {
    for (std::size_t word = 0; word < crossed.size(); ++word) {
      before[word] = static_cast<std::uint16_t>(count);
      count += static_cast<std::uint32_t>(std::popcount(crossed[word]));
    }
  }
  Index vertex(std::size_t b) const {
    const std::uint64_t lower = crossed[b / 64] & ((std::uint64_t{1} << (b % 64)) - 1);
    return first + before[b / 64] + static_cast<std::uint32_t>(std::popcount(lower));
  }
};

using Triangle = std::array<Index, 3>;
using CellCorners = std::array<int, 8>;

/// The corners of a cell relative to its first, in a padded field.
CellCorners corner_offsets() {
  CellCorners offsets{};
  for (int k = 0; k < 8; ++k) {
    offsets[static_cast<std::size_t>(k)] =
        (k & 1) + ((k >> 1) & 1) * padded + (k >> 2) * padded * padded;
  }
  return offsets;
}

class SurfaceExtractor {
 public:
  SurfaceExtractor(const TsdfVolume& volume, const SurfaceExtractionOptions& options)
      : volume_(volume),
        min_weight_(
            static_cast<std::uint16_t>(std::clamp(16.0 * options.min_weight, 1.0, 65535.0))),
        sides_(volume.index().size(), 0),
        vertices_(volume.index().size()) {}

  TriangleMesh extract() {
    find_sides();
    mark_edges();
    TriangleMesh mesh;
    const Index count = number_vertices();
    mesh.vertices.resize(count, 3);
    mesh.normals.resize(count, 3);
    if (has_colors()) mesh.colors.resize(count, 3);
    place_vertices(mesh);
    connect(mesh);
    return mesh;
  }

 private:
  static constexpr unsigned before = 1, behind = 2;

  /// Calls visit(slot, field) for the blocks through which the surface may pass.
  template <class Visit>
  void for_each_block(const Visit& visit) const {
    parallel_for_blocks(vertices_.size(), 32, [&](std::size_t begin, std::size_t end) {
      PaddedField field;
      for (std::size_t slot = begin; slot < end; ++slot) {
        if (!may_hold_surface(slot)) continue;
        read_field(volume_, volume_.index().blocks()[slot], field);
        visit(slot, field);
      }
    });
  }

  /// Whether a block and those after it, which its cells reach, have seen both sides of a surface.
  bool may_hold_surface(std::size_t slot) const {
    const Eigen::Vector3i& block = volume_.index().blocks()[slot];
    unsigned sides = sides_[slot];
    for (int k = 1; k < 8 && sides != (before | behind); ++k) {
      const std::int32_t next =
          volume_.index().find(block + Eigen::Vector3i(k & 1, (k >> 1) & 1, k >> 2));
      if (next != BlockIndex::none) sides |= sides_[static_cast<std::size_t>(next)];
    }
    return sides == (before | behind);
  }

  void find_sides() {
    parallel_for_blocks(sides_.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t slot = begin; slot < end; ++slot) {
        const TsdfBlock& block = volume_.block(slot);
        for (std::size_t i = 0; i < TsdfBlock::voxels; ++i) {
          if (block.weight[i] == 0) continue;
          sides_[slot] =
              static_cast<std::uint8_t>(sides_[slot] | (block.distance[i] < 0 ? behind : before));
        }
      }
    });
  }

  /// Which corners of a cell are behind the surface; 0 where one was not seen enough.
  int corners_behind(const PaddedField& field, int base) const {
    int corners = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const auto at = static_cast<std::size_t>(base + offsets_[k]);
      if (field.weight[at] < min_weight_) return 0;
      if (field.distance[at] < 0.0F) corners |= 1 << k;
    }
    return corners;
  }

  /// An edge carries a vertex where one of the four cells about it is seen.
  void mark_edges() {
    for_each_block([&](std::size_t slot, const PaddedField& field) {
      for (int voxel = 0; voxel < TsdfBlock::voxels; ++voxel) {
        const int base = PaddedField::at(voxel & 7, (voxel >> 3) & 7, voxel >> 6);
        for (int axis = 0; axis < 3; ++axis) {
          if (is_crossed(field, base, axis)) vertices_[slot].set(BlockVertices::bit(voxel, axis));
        }
      }
      vertices_[slot].number();
    });
  }

  bool is_crossed(const PaddedField& field, int base, int axis) const {
    const auto here = static_cast<std::size_t>(base);
    const auto there = static_cast<std::size_t>(base + PaddedField::stride[axis]);
    if ((field.distance[here] < 0.0F) == (field.distance[there] < 0.0F)) return false;
    const int a = PaddedField::stride[(axis + 1) % 3], b = PaddedField::stride[(axis + 2) % 3];
    for (const int cell : {base, base - a, base - b, base - a - b}) {
      const int corners = corners_behind(field, cell);
      if (corners != 0 && corners != 255) return true;
    }
    return false;
  }

  Index number_vertices() {
    std::uint32_t count = 0;
    for (BlockVertices& block : vertices_) {
      block.first = count;
      count += block.count;
    }
    return count;
  }

  bool has_colors() const {
    for (std::size_t slot = 0; slot < vertices_.size(); ++slot) {
      if (volume_.colors(slot) != nullptr) return true;
    }
    return false;
  }

  void place_vertices(TriangleMesh& mesh) const {
    for_each_block([&](std::size_t slot, const PaddedField& field) {
      const BlockVertices& block = vertices_[slot];
      for (int voxel = 0; voxel < TsdfBlock::voxels; ++voxel) {
        for (int axis = 0; axis < 3; ++axis) {
          const std::size_t bit = BlockVertices::bit(voxel, axis);
          if ((block.crossed[bit / 64] >> (bit % 64) & 1) == 0) continue;
          place_vertex(slot, field, voxel, axis, block.vertex(bit), mesh);
        }
      }
    });
  }

  void place_vertex(std::size_t slot, const PaddedField& field, int voxel, int axis, Index vertex,
                    TriangleMesh& mesh) const {
    const int x = voxel & 7, y = (voxel >> 3) & 7, z = voxel >> 6;
    const int base = PaddedField::at(x, y, z);
    const int next = base + PaddedField::stride[axis];
    const float d0 = field.distance[static_cast<std::size_t>(base)];
    const float d1 = field.distance[static_cast<std::size_t>(next)];
    const float between = d0 / (d0 - d1);
    Eigen::Vector3f place =
        Eigen::Vector3f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z))
            .array() +
        0.5F;
    place[axis] += between;
    const Eigen::Vector3f corner = (volume_.index().blocks()[slot] * edge).cast<float>();
    mesh.vertices.row(vertex) =
        ((corner + place) * static_cast<float>(volume_.voxel_size())).transpose();
    const Eigen::Vector3f gradient =
        (1.0F - between) * gradient_at(field, base) + between * gradient_at(field, next);
    const float norm = gradient.norm();
    mesh.normals.row(vertex) =
        (norm > 0.0F ? Eigen::Vector3f(gradient / norm)
                     : Eigen::Vector3f((d0 < d1 ? 1.0F : -1.0F) * Eigen::Vector3f::Unit(axis)))
            .transpose();
    if (mesh.colors.rows() != 0) {
      mesh.colors.row(vertex) = color_at(slot, voxel, axis, between);
    }
  }

  /// The gradient of the field at a voxel, one-sided at the end of what was seen.
  static Eigen::Vector3f gradient_at(const PaddedField& field, int base) {
    Eigen::Vector3f gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const auto here = static_cast<std::size_t>(base);
      const auto low = static_cast<std::size_t>(base - PaddedField::stride[axis]);
      const auto high = static_cast<std::size_t>(base + PaddedField::stride[axis]);
      const bool has_low = field.weight[low] != 0, has_high = field.weight[high] != 0;
      const float from = has_low ? field.distance[low] : field.distance[here];
      const float to = has_high ? field.distance[high] : field.distance[here];
      gradient[axis] = (to - from) / (has_low && has_high ? 2.0F : 1.0F);
    }
    return gradient;
  }

  /// The mean of the colours of an edge's voxels, by their nearness to the vertex.
  Eigen::Matrix<std::uint8_t, 1, 3> color_at(std::size_t slot, int voxel, int axis,
                                             float between) const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float total = 0.0F;
    const auto add = [&](std::size_t home, int at, float weight) {
      const ColorBlock* colors = volume_.colors(home);
      if (colors == nullptr) return;
      const auto& rgbw = colors->rgbw[static_cast<std::size_t>(at)];
      if (rgbw[3] == 0) return;
      sum += (weight + 1e-3F) * Eigen::Vector3f(rgbw[0], rgbw[1], rgbw[2]);
      total += weight + 1e-3F;
    };
    add(slot, voxel, 1.0F - between);
    const auto [next_slot, next_voxel] = neighbor(slot, voxel, axis);
    if (next_slot != BlockIndex::none)
      add(static_cast<std::size_t>(next_slot), next_voxel, between);
    if (total == 0.0F) return Eigen::Matrix<std::uint8_t, 1, 3>::Constant(160);
    return (sum / total + Eigen::Vector3f::Constant(0.5F)).transpose().cast<std::uint8_t>();
  }

  /// The next voxel along an axis.
  std::pair<std::int32_t, int> neighbor(std::size_t slot, int voxel, int axis) const {
    const int shift = 3 * axis;
    if (((voxel >> shift) & 7) != 7) return {static_cast<std::int32_t>(slot), voxel + (1 << shift)};
    const Eigen::Vector3i next = volume_.index().blocks()[slot] + Eigen::Vector3i::Unit(axis);
    return {volume_.index().find(next), voxel & ~(7 << shift)};
  }

  void connect(TriangleMesh& mesh) const {
    std::vector<std::vector<Triangle>> lists(vertices_.size());
    for_each_block([&](std::size_t slot, const PaddedField& field) {
      for (int voxel = 0; voxel < TsdfBlock::voxels; ++voxel) {
        const int base = PaddedField::at(voxel & 7, (voxel >> 3) & 7, voxel >> 6);
        const CellTriangles& cell =
            cell_triangles()[static_cast<std::size_t>(corners_behind(field, base))];
        for (std::size_t k = 0; k < cell.count; ++k) {
          Triangle triangle{};
          for (std::size_t c = 0; c < 3; ++c) {
            triangle[c] = vertex_of(slot, voxel, cell.triangles[k][c]);
          }
          lists[slot].push_back(triangle);
        }
      }
    });
    std::size_t count = 0;
    for (const auto& list : lists) count += list.size();
    mesh.triangles.resize(static_cast<Eigen::Index>(count), 3);
    Eigen::Index row = 0;
    for (const auto& list : lists) {
      for (const Triangle& t : list) mesh.triangles.row(row++) << t[0], t[1], t[2];
    }
  }

  Index vertex_of(std::size_t slot, int voxel, const CellEdge& on) const {
    std::pair<std::int32_t, int> home{static_cast<std::int32_t>(slot), voxel};
    for (int axis = 0; axis < 3; ++axis) {
      if ((on.corner >> axis & 1) != 0) {
        home = neighbor(static_cast<std::size_t>(home.first), home.second, axis);
      }
    }
    return vertices_[static_cast<std::size_t>(home.first)].vertex(
        BlockVertices::bit(home.second, on.axis));
  }

  const TsdfVolume& volume_;
  std::uint16_t min_weight_;
  std::vector<std::uint8_t> sides_;  ///< of the surface that a block has seen
  CellCorners offsets_ = corner_offsets();
  std::vector<BlockVertices> vertices_;
};

/// The root of a vertex' tree, which gets shorter on the way.
Index find_root(std::vector<Index>& parents, Index i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

/// The mesh without its connected pieces of fewer than `least` triangles.
TriangleMesh without_small_pieces(const TriangleMesh& mesh, int least) {
  std::vector<Index> parents(static_cast<std::size_t>(mesh.vertices.rows()));
  std::iota(parents.begin(), parents.end(), Index{0});
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Index root = find_root(parents, mesh.triangles(t, 0));
    parents[find_root(parents, mesh.triangles(t, 1))] = root;
    parents[find_root(parents, mesh.triangles(t, 2))] = root;
  }
  std::vector<int> triangles(parents.size(), 0);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    int& count = triangles[find_root(parents, mesh.triangles(t, 0))];
    count = std::min(count + 1, least);
  }
  std::vector<Index> kept, place(parents.size(), 0);
  for (Index v = 0; v < parents.size(); ++v) {
    if (triangles[find_root(parents, v)] < least) continue;
    place[v] = static_cast<Index>(kept.size());
    kept.push_back(v);
  }
  TriangleMesh result;
  result.vertices = mesh.vertices(kept, Eigen::all);
  result.normals = mesh.normals(kept, Eigen::all);
  if (mesh.colors.rows() != 0) result.colors = mesh.colors(kept, Eigen::all);
  result.triangles.resize(mesh.triangles.rows(), 3);
  Eigen::Index row = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    if (triangles[find_root(parents, mesh.triangles(t, 0))] < least) continue;
    for (int c = 0; c < 3; ++c) result.triangles(row, c) = place[mesh.triangles(t, c)];
    ++row;
  }
  result.triangles.conservativeResize(row, 3);
  return result;
}

}  // namespace

void SurfaceExtractionOptions::validate() const {
  require_option(min_weight >= 0 && min_weight <= 2000, "min_weight", "0 to 2000", min_weight);
  require_option(min_triangles >= 1, "min_triangles", "at least 1", min_triangles);
}

TriangleMesh extract_surface(const TsdfVolume& volume, const SurfaceExtractionOptions& options) {
  options.validate();
  return without_small_pieces(SurfaceExtractor(volume, options).extract(), options.min_triangles);
}

SurfaceExtractionOptions surface_of_few(const SurfaceExtractionOptions& options,
                                        std::size_t frames) {
  constexpr double usual_frames = 200.0;
  constexpr double one_look = 1.0 / 16.0;  // the least weight of a measurement
  SurfaceExtractionOptions few = options;
  const double share = std::min(1.0, static_cast<double>(frames) / usual_frames);
  few.min_weight = std::min(options.min_weight, std::max(one_look, share * options.min_weight));
  return few;
}

}  // namespace symscene
