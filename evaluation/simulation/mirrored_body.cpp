#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "mesh_builder.hpp"
#include "simulation/shapes.hpp"

namespace symscene {
namespace {

/// Approximate distance to an ellipsoid: zero on its surface, accurate near it.
double distance_to(const Ellipsoid& part, const Eigen::Vector3d& p) {
  const Eigen::Vector3d scaled = (p - part.center).cwiseQuotient(part.radii);
  const double length = scaled.norm();
  const double slope = scaled.cwiseQuotient(part.radii).norm();
  return slope > 1e-12 ? length * (length - 1.0) / slope : -part.radii.minCoeff();
}

/// Negative inside. The sum of exponentials is smooth where parts meet.
double body_value(std::span<const Ellipsoid> parts, double blend, const Eigen::Vector3d& p) {
  const Eigen::Vector3d mirrored(p.x(), -p.y(), p.z());
  double sum = 0.0;
  for (const Ellipsoid& part : parts) {
    sum += std::exp(-distance_to(part, p) / blend);
    sum += std::exp(-distance_to(part, mirrored) / blend);
  }
  const double body = -blend * (std::log(sum + 1e-300) - std::numbers::ln2);
  return std::max(body, -p.z());
}

/// Marching tetrahedra over the half y >= 0 of a grid that has a layer of vertices on y = 0.
class HalfBodyMesher {
 public:
  HalfBodyMesher(std::span<const Ellipsoid> parts, double blend, double cell) : cell_(cell) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9);
    Eigen::Vector3d high = -low;
    for (const Ellipsoid& part : parts) {
      const Eigen::Vector3d reach = part.radii.array() + 2.0 * blend;
      low = low.cwiseMin(part.center - reach);
      high = high.cwiseMax(part.center + reach);
    }
    low.y() = 0.0;
    low.z() = -1.5 * cell;  // half a cell off z = 0, where the body is cut off
    origin_ = low;
    for (int axis = 0; axis < 3; ++axis) {
      size_[axis] = static_cast<int>(std::ceil((high[axis] - low[axis]) / cell)) + 2;
    }
    sample(parts, blend);
  }

  TriangleMesh mesh() {
    for (int z = 0; z + 1 < size_.z(); ++z) {
      for (int y = 0; y + 1 < size_.y(); ++y) {
        for (int x = 0; x + 1 < size_.x(); ++x) add_cube({x, y, z});
      }
    }
    return mirror_and_join(mesh_.take());
  }

 private:
  Eigen::Vector3d position(const Eigen::Vector3i& lattice) const {
    return origin_ + cell_ * lattice.cast<double>();
  }
  std::size_t index(const Eigen::Vector3i& lattice) const {
    return static_cast<std::size_t>((lattice.z() * size_.y() + lattice.y()) * size_.x() +
                                    lattice.x());
  }

  void sample(std::span<const Ellipsoid> parts, double blend) {
    for (int z = 0; z < size_.z(); ++z) {
      for (int y = 0; y < size_.y(); ++y) {
        for (int x = 0; x < size_.x(); ++x) {
          values_.push_back(body_value(parts, blend, position({x, y, z})));
        }
      }
    }
  }

  /// The six tetrahedra around the cube's long diagonal, all of one orientation.
  void add_cube(const Eigen::Vector3i& base) {
    constexpr std::array<std::array<int, 3>, 6> axis_orders = {
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (std::size_t k = 0; k < 6; ++k) {
      std::array<Eigen::Vector3i, 4> corners{base, base, base, base};
      for (std::size_t step = 0; step < 3; ++step) {
        for (std::size_t later = step; later < 3; ++later) {
          corners[later + 1][axis_orders[k][step]] += 1;
        }
      }
      if (k >= 3)
        std::swap(corners[2], corners[3]);  // odd permutations have the opposite orientation
      add_tetrahedron(corners);
    }
  }

  void add_tetrahedron(const std::array<Eigen::Vector3i, 4>& corners) {
    std::array<std::size_t, 4> inside{};
    std::array<std::size_t, 4> outside{};
    std::size_t in = 0;
    std::size_t out = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (values_[index(corners[k])] < 0.0) {
        inside[in++] = k;
      } else {
        outside[out++] = k;
      }
    }
    const auto cut = [&](std::size_t a, std::size_t b) {
      return edge_vertex(corners[a], corners[b]);
    };
    if (in == 1) {
      add_outward(cut(inside[0], outside[0]), cut(inside[0], outside[1]),
                  cut(inside[0], outside[2]), position(corners[inside[0]]));
    } else if (in == 3) {
      add_outward(cut(inside[0], outside[0]), cut(inside[1], outside[0]),
                  cut(inside[2], outside[0]), position(corners[inside[0]]));
    } else if (in == 2) {
      const Index a = cut(inside[0], outside[0]), b = cut(inside[0], outside[1]);
      const Index c = cut(inside[1], outside[1]), d = cut(inside[1], outside[0]);
      const Eigen::Vector3d within = position(corners[inside[0]]);
      add_outward(a, b, c, within);
      add_outward(a, c, d, within);
    }
  }

  void add_outward(Index a, Index b, Index c, const Eigen::Vector3d& within) {
    const Eigen::Vector3d normal = (points_[b] - points_[a]).cross(points_[c] - points_[a]);
    if (normal.dot(points_[a] - within) >= 0.0) {
      mesh_.add_triangle(a, b, c);
    } else {
      mesh_.add_triangle(a, c, b);
    }
  }

  Index edge_vertex(const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
    const std::size_t low = std::min(index(a), index(b));
    const std::size_t high = std::max(index(a), index(b));
    const auto [entry, added] =
        vertices_.try_emplace((std::uint64_t{low} << 32U) | high, mesh_.vertex_count());
    if (added) {
      const double va = values_[index(a)], vb = values_[index(b)];
      // Kept off the corners, so that no triangle collapses.
      const double t = std::clamp(va / (va - vb), 0.01, 0.99);
      const Eigen::Vector3d p = position(a) + t * (position(b) - position(a));
      points_.push_back(p);
      mesh_.add_vertex(p);
    }
    return entry->second;
  }

  static TriangleMesh mirror_and_join(const TriangleMesh& half) {
    MeshBuilder whole;
    std::vector<Index> image;
    for (Eigen::Index i = 0; i < half.vertices.rows(); ++i) {
      whole.add_vertex(half.vertices.row(i).transpose().cast<double>());
    }
    for (Eigen::Index i = 0; i < half.vertices.rows(); ++i) {
      Eigen::Vector3d p = half.vertices.row(i).transpose().cast<double>();
      const bool shared = p.y() == 0.0;
      p.y() = -p.y();
      image.push_back(shared ? static_cast<Index>(i) : whole.add_vertex(p));
    }
    for (Eigen::Index t = 0; t < half.triangles.rows(); ++t) {
      const auto corners = half.triangles.row(t);
      whole.add_triangle(corners[0], corners[1], corners[2]);
      whole.add_triangle(image[corners[0]], image[corners[2]], image[corners[1]]);
    }
    return whole.take();
  }

  double cell_;
  Eigen::Vector3d origin_;
  Eigen::Vector3i size_;
  std::vector<double> values_;
  MeshBuilder mesh_;
  std::vector<Eigen::Vector3d> points_;
  std::unordered_map<std::uint64_t, Index> vertices_;
};

}  // namespace

TriangleMesh make_mirrored_body(std::span<const Ellipsoid> parts, double blend, double cell) {
  return HalfBodyMesher(parts, blend, cell).mesh();
}

}  // namespace symscene
