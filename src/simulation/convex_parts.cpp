#include "symscene/simulation/convex_parts.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/parallel.hpp"

#ifdef SYMSCENE_PHYSICS
#include <bullet/HACD/hacdHACD.h>
#endif

namespace symscene {
namespace {

/// Unit vectors, the mean of the triangles' normals by area.
Points vertex_normals(const TriangleMesh& mesh) {
  Points normals = Points::Zero(mesh.vertices.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3f a = mesh.vertices.row(mesh.triangles(t, 0));
    const Eigen::Vector3f b = mesh.vertices.row(mesh.triangles(t, 1));
    const Eigen::Vector3f c = mesh.vertices.row(mesh.triangles(t, 2));
    const Eigen::Vector3f normal = (b - a).cross(c - a);
    for (int k = 0; k < 3; ++k) normals.row(mesh.triangles(t, k)) += normal.transpose();
  }
  normals.rowwise().normalize();
  return normals;
}

/// Vertices of one cell that face alike become one, so that the two sides of a wall stay apart.
TriangleMesh thinned(const TriangleMesh& mesh, float cell) {
  const Points normals = vertex_normals(mesh);
  std::map<std::array<int, 4>, Index> groups;
  std::vector<Index> group_of(static_cast<std::size_t>(mesh.vertices.rows()));
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Eigen::Vector3i at = (mesh.vertices.row(i) / cell).array().floor().cast<int>();
    Eigen::Index axis = 0;
    normals.row(i).cwiseAbs().maxCoeff(&axis);
    const int side = static_cast<int>(2 * axis) + (normals(i, axis) < 0 ? 1 : 0);
    group_of[static_cast<std::size_t>(i)] =
        groups.try_emplace({at.x(), at.y(), at.z(), side}, static_cast<Index>(groups.size()))
            .first->second;
  }
  TriangleMesh result;
  result.vertices = Points::Zero(static_cast<Eigen::Index>(groups.size()), 3);
  Eigen::VectorXf members = Eigen::VectorXf::Zero(result.vertices.rows());
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Index group = group_of[static_cast<std::size_t>(i)];
    result.vertices.row(group) += mesh.vertices.row(i);
    members[group] += 1.0F;
  }
  result.vertices.array().colwise() /= members.array();
  std::set<std::array<Index, 3>> kept;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    std::array<Index, 3> corners{};
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] = group_of[mesh.triangles(t, k)];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2])
      kept.insert(corners);
  }
  result.triangles.resize(static_cast<Eigen::Index>(kept.size()), 3);
  Eigen::Index row = 0;
  for (const auto& [a, b, c] : kept) result.triangles.row(row++) << a, b, c;
  return result;
}

Points triangle_centers(const TriangleMesh& mesh) {
  Points centers(mesh.triangles.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    centers.row(t) =
        (mesh.vertices.row(mesh.triangles(t, 0)) + mesh.vertices.row(mesh.triangles(t, 1)) +
         mesh.vertices.row(mesh.triangles(t, 2))) /
        3.0F;
  }
  return centers;
}

/// How deep below its hull a mesh lies at most: the depth below the planes that touch the hull
/// along many directions, the mesh' own among them. [m]
double hull_depth(const TriangleMesh& mesh) {
  constexpr Index directions = 600;
  const Points normals = vertex_normals(mesh);
  const auto size = static_cast<Index>(normals.rows());
  Eigen::VectorXf depth = Eigen::VectorXf::Constant(size, std::numeric_limits<float>::infinity());
  for (const Index k : evenly_spread(size, std::min(size, directions))) {
    const Eigen::VectorXf heights = mesh.vertices * normals.row(k).transpose();
    depth = depth.cwiseMin((heights.maxCoeff() - heights.array()).matrix());
  }
  return depth.maxCoeff();
}

/// Triangles that share an edge, as pairs of parts with the number of edges between them.
std::map<std::pair<Index, Index>, Index> borders(const TriangleMesh& mesh,
                                                 const std::vector<Index>& partition) {
  std::map<std::pair<Index, Index>, Index> first_at;
  std::map<std::pair<Index, Index>, Index> edges;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Index part = partition[static_cast<std::size_t>(t)];
    for (int k = 0; k < 3; ++k) {
      const auto edge = std::minmax(mesh.triangles(t, k), mesh.triangles(t, (k + 1) % 3));
      const auto [other, is_new] = first_at.try_emplace({edge.first, edge.second}, part);
      if (is_new || other->second == part) continue;
      ++edges[{part, other->second}];
      ++edges[{other->second, part}];
    }
  }
  return edges;
}

/// Joins the smallest part with that along most of its border until there are `most` of them; what
/// has no neighbour stays.
void join_small_parts(const TriangleMesh& mesh, std::size_t most, std::vector<Index>& partition) {
  auto edges = borders(mesh, partition);
  std::map<Index, std::size_t> sizes;
  for (const Index part : partition) ++sizes[part];
  std::set<std::pair<std::size_t, Index>> by_size;
  for (const auto& [part, size] : sizes) by_size.insert({size, part});
  std::vector<Index> renamed(*std::max_element(partition.begin(), partition.end()) + 1);
  std::iota(renamed.begin(), renamed.end(), Index{0});
  for (std::size_t count = sizes.size(); count > most && !by_size.empty();) {
    const auto [size, small] = *by_size.begin();
    by_size.erase(by_size.begin());
    Index widest = small;
    Index width = 0;
    std::vector<std::pair<Index, Index>> around;
    for (auto at = edges.lower_bound({small, 0}); at != edges.end() && at->first.first == small;
         ++at) {
      around.emplace_back(at->first.second, at->second);
      if (at->second > width) std::tie(widest, width) = around.back();
    }
    if (widest == small) continue;
    for (const auto& [other, shared] : around) {
      edges.erase({small, other});
      edges.erase({other, small});
      if (other == widest) continue;
      edges[{widest, other}] += shared;
      edges[{other, widest}] += shared;
    }
    by_size.erase({sizes[widest], widest});
    sizes[widest] += size;
    by_size.insert({sizes[widest], widest});
    renamed[small] = widest;
    --count;
  }
  for (Index& part : partition) {
    while (renamed[part] != part) part = renamed[part];
  }
}

#ifdef SYMSCENE_PHYSICS

/// For each triangle the nearly convex part that it belongs to, from 0.
std::vector<Index> convex_partition(const TriangleMesh& mesh, double diagonal, double concavity) {
  std::vector<HACD::Vec3<HACD::Real>> points;
  std::vector<HACD::Vec3<long>> triangles;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i)
    points.emplace_back(mesh.vertices(i, 0), mesh.vertices(i, 1), mesh.vertices(i, 2));
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    triangles.emplace_back(mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2));
  HACD::HACD hacd;
  hacd.SetPoints(points.data());
  hacd.SetNPoints(points.size());
  hacd.SetTriangles(triangles.data());
  hacd.SetNTriangles(triangles.size());
  hacd.SetCompacityWeight(1e-4);
  hacd.SetVolumeWeight(0.0);
  hacd.SetConnectDist(30.0);
  hacd.SetNClusters(1);
  hacd.SetNVerticesPerCH(64);
  hacd.SetConcavity(concavity / diagonal * hacd.GetScaleFactor());
  hacd.SetAddExtraDistPoints(false);
  hacd.SetAddFacesPoints(false);
  std::vector<Index> partition(triangles.size(), 0);
  if (!hacd.Compute() || hacd.GetPartition() == nullptr) return partition;
  for (std::size_t t = 0; t < partition.size(); ++t)
    partition[t] = static_cast<Index>(std::max(0L, hacd.GetPartition()[t]));
  return partition;
}

#else

std::vector<Index> convex_partition(const TriangleMesh&, double, double) {
  throw InputError("this build of SymScene",
                   "physics (the packages libmujoco-dev and "
                   "libbullet-extras-dev, then configure again)",
                   "none");
}

#endif

/// For every triangle of `mesh` the part of the thinned mesh' triangle nearest to it.
std::vector<Index> part_of_triangles(const TriangleMesh& mesh, const TriangleMesh& thin,
                                     const std::vector<Index>& partition, float reach) {
  const CellList nearest_thin(triangle_centers(thin), reach);
  const Points centers = triangle_centers(mesh);
  std::vector<Index> parts(static_cast<std::size_t>(centers.rows()), CellList::none);
  for (Eigen::Index t = 0; t < centers.rows(); ++t) {
    const Index near = nearest_thin.nearest(centers.row(t).transpose(), 4.0F * reach).first;
    if (near != CellList::none) parts[static_cast<std::size_t>(t)] = partition[near];
  }
  return parts;
}

/// The vertices of each part's triangles and, so that no part is flat, the same a skin further in.
ConvexParts gathered(const TriangleMesh& mesh, const std::vector<Index>& part_of, float skin) {
  const Points inner = mesh.vertices - skin * vertex_normals(mesh);
  std::map<Index, std::set<Index>> members;
  for (std::size_t t = 0; t < part_of.size(); ++t) {
    if (part_of[t] == CellList::none) continue;
    for (int k = 0; k < 3; ++k)
      members[part_of[t]].insert(mesh.triangles(static_cast<Eigen::Index>(t), k));
  }
  ConvexParts parts;
  for (const auto& [part, vertices] : members) {
    Points points(2 * static_cast<Eigen::Index>(vertices.size()), 3);
    Eigen::Index row = 0;
    for (const Index v : vertices) {
      points.row(row++) = mesh.vertices.row(v);
      points.row(row++) = inner.row(v);
    }
    parts.push_back(std::move(points));
  }
  return parts;
}

}  // namespace

bool has_physics() {
#ifdef SYMSCENE_PHYSICS
  return true;
#else
  return false;
#endif
}

bool is_solid(const TriangleMesh& mesh) {
  constexpr float thinnest = 1e-3F;
  if (mesh.triangles.rows() < 4 || !mesh.vertices.allFinite()) return false;
  const Points along_axes = mesh.vertices * principal_axes(mesh.vertices).cast<float>();
  return bounding_box(along_axes).extent().minCoeff() > thinnest;
}

void ConvexPartsOptions::validate() const {
  require_option(concavity > 0, "concavity", "a positive number", concavity);
  require_option(cell > 0, "cell", "a positive number", cell);
  require_option(max_cells >= 4, "max_cells", "at least 4", max_cells);
  require_option(max_parts >= 1, "max_parts", "at least 1", max_parts);
  require_option(skin > 0, "skin", "a positive number", skin);
}

ConvexParts convex_parts(const TriangleMesh& mesh, const ConvexPartsOptions& options) {
  options.validate();
  if (!is_solid(mesh)) throw InputError("a mesh", "a solid at least 1 mm thick", "another");
  if (hull_depth(mesh) < options.concavity) return {mesh.vertices};
  const double diagonal = bounding_box(mesh.vertices).extent().norm();
  const auto cell = static_cast<float>(std::max(options.cell, diagonal / options.max_cells));
  const TriangleMesh thin = thinned(mesh, cell);
  std::vector<Index> partition = convex_partition(thin, diagonal, options.concavity);
  join_small_parts(thin, static_cast<std::size_t>(options.max_parts), partition);
  return gathered(mesh, part_of_triangles(mesh, thin, partition, cell),
                  static_cast<float>(options.skin));
}

std::vector<const ConvexParts*> ConvexPartsCache::of(std::span<const ObjectModel> models) {
  std::vector<std::pair<const ObjectModel*, ConvexParts*>> missing;
  for (const ObjectModel& model : models) {
    const auto [place, is_new] = parts_.try_emplace(model.name);
    if (is_new) missing.emplace_back(&model, &place->second);
  }
  parallel_for_each(missing.size(), [&](std::size_t i) {
    *missing[i].second = convex_parts(missing[i].first->mesh, options_);
  });
  std::vector<const ConvexParts*> parts;
  for (const ObjectModel& model : models) parts.push_back(&parts_.at(model.name));
  return parts;
}

}  // namespace symscene
