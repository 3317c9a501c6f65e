#include "reconstruction/surface_extraction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "block_vertices.hpp"
#include "core/cell_triangles.hpp"
#include "core/parallel.hpp"
#include "padded_field.hpp"
#include "small_pieces.hpp"

namespace symscene {
namespace {

using Triangle = std::array<Index, 3>;
using CellCorners = std::array<int, 8>;

/// The corners of a cell relative to its first, in a padded field.
CellCorners corner_offsets() {
  CellCorners offsets{};
  for (int k = 0; k < 8; ++k) {
    offsets[static_cast<std::size_t>(k)] =
        (k & 1) + ((k >> 1) & 1) * PaddedField::stride[1] + (k >> 2) * PaddedField::stride[2];
  }
  return offsets;
}

/// The corners of a cell that share an edge with one of a set.
constexpr int next_corners(int corners) {
  return ((corners & 0x55) << 1) | ((corners >> 1) & 0x55) | ((corners & 0x33) << 2) |
         ((corners >> 2) & 0x33) | ((corners & 0x0F) << 4) | (corners >> 4);
}

/// The weights that the voxels of each block need to count as seen, by slot: a number of frontal
/// looks from where the block was seen, in proportion to the frames below `full_frames`.
/// [Measurement::weight_units]
std::vector<std::uint16_t> weights_needed(const TsdfVolume& volume,
                                          const SurfaceExtractionOptions& options) {
  std::vector<std::uint16_t> needed(volume.index().size(), 1);
  for (std::size_t slot = 0; slot < needed.size(); ++slot) {
    const TsdfVolume::Looks& looks = volume.looks(slot);
    if (looks.frames == 0) continue;
    const double one_look = static_cast<double>(looks.frontal_weight) / looks.frames;
    const double share = std::min(1.0, static_cast<double>(looks.frames) / options.full_frames);
    needed[slot] = static_cast<std::uint16_t>(
        std::clamp(std::ceil(options.min_looks * share * one_look), 1.0, 65535.0));
  }
  return needed;
}

class SurfaceExtractor {
 public:
  SurfaceExtractor(const TsdfVolume& volume, const SurfaceExtractionOptions& options)
      : volume_(volume),
        needed_weights_(weights_needed(volume, options)),
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

  /// Calls visit(slot, field) in parallel for the blocks through which the surface may pass.
  template <class Visit>
  void for_each_block(const Visit& visit) const {
    parallel_for_blocks(vertices_.size(), 32, [&](std::size_t begin, std::size_t end) {
      PaddedField field;
      for (std::size_t slot = begin; slot < end; ++slot) {
        if (!may_hold_surface(slot)) continue;
        field.read(volume_, volume_.index().blocks()[slot], needed_weights_);
        visit(slot, field);
      }
    });
  }

  /// Whether a block and the next ones, into which its cells reach, have voxels on both sides.
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

  /// The set of corners of a cell behind the surface; 0 if not all edges that it crosses were seen.
  /// Corners that were not seen, as they lie deep below a surface that was seen at a flat angle,
  /// count as behind it if none of them is next to one before the surface.
  int corners_behind(const PaddedField& field, int base) const {
    int front = 0, unseen = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const auto at = static_cast<std::size_t>(base + offsets_[k]);
      if (field.seen[at] == 0) {
        unseen |= 1 << k;
      } else if (field.distance[at] >= 0.0F) {
        front |= 1 << k;
      }
    }
    return (next_corners(front) & unseen) != 0 ? 0 : 255 & ~front;
  }

  /// An edge carries a vertex if the surface crosses it and one of the four cells around it is
  /// seen.
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
          if (!block.is_set(bit)) continue;
          place_vertex({slot, voxel, axis}, field, block.vertex(bit), mesh);
        }
      }
    });
  }

  /// The edge from a voxel's centre to that of the next voxel along an axis.
  struct VoxelEdge {
    std::size_t slot;  ///< of the voxel's block
    int voxel;
    int axis;
  };

  void place_vertex(const VoxelEdge& edge, const PaddedField& field, Index vertex,
                    TriangleMesh& mesh) const {
    const auto [slot, voxel, axis] = edge;
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
    const Eigen::Vector3f corner = (volume_.index().blocks()[slot] * TsdfBlock::edge).cast<float>();
    mesh.vertices.row(vertex) =
        ((corner + place) * static_cast<float>(volume_.voxel_size())).transpose();
    const Eigen::Vector3f gradient =
        (1.0F - between) * field.gradient(base) + between * field.gradient(next);
    const float norm = gradient.norm();
    mesh.normals.row(vertex) =
        (norm > 0.0F ? Eigen::Vector3f(gradient / norm)
                     : Eigen::Vector3f((d0 < d1 ? 1.0F : -1.0F) * Eigen::Vector3f::Unit(axis)))
            .transpose();
    if (mesh.colors.rows() != 0) {
      mesh.colors.row(vertex) = color_at(slot, voxel, axis, between);
    }
  }

  /// The interpolated colour of an edge's voxels.
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
    // Not from corner to corner: blocks on the way there need not exist.
    Eigen::Vector3i block = volume_.index().blocks()[slot];
    int home = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int at = ((voxel >> (3 * axis)) & 7) + ((on.corner >> axis) & 1);
      block[axis] += at >> 3;
      home |= (at & 7) << (3 * axis);
    }
    const bool same = block == volume_.index().blocks()[slot];
    const std::size_t found = same ? slot : static_cast<std::size_t>(volume_.index().find(block));
    return vertices_[found].vertex(BlockVertices::bit(home, on.axis));
  }

  const TsdfVolume& volume_;
  std::vector<std::uint16_t> needed_weights_;  ///< by slot [Measurement::weight_units]
  std::vector<std::uint8_t> sides_;            ///< of the surface on which a block has voxels
  CellCorners offsets_ = corner_offsets();
  std::vector<BlockVertices> vertices_;
};

}  // namespace

TriangleMesh extract_surface(const TsdfVolume& volume, const SurfaceExtractionOptions& options) {
  options.validate();
  return without_small_pieces(SurfaceExtractor(volume, options).extract(), options.min_triangles);
}

}  // namespace symscene
