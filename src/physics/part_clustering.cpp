#include "part_clustering.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "core/vertex_normals.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

constexpr Index other_samples = 300;  // of all vertices
constexpr Index samples = 32;         // of a part's vertices, for its depth
// Cost per metre of the extent of a part, so that parts stay compact. [m]
constexpr double compactness = 0.02;

PointIndices joined(const PointIndices& a, const PointIndices& b) {
  PointIndices both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

/// The 13 directions of a cube's faces, edges and corners, and their opposites. Unit vectors.
Points fixed_directions() {
  Points directions(26, 3);
  Eigen::Index row = 0;
  for (int code = 0; code < 27; ++code) {
    const Eigen::Vector3f d(static_cast<float>(code % 3 - 1), static_cast<float>(code / 3 % 3 - 1),
                            static_cast<float>(code / 9 - 1));
    if (code != 13) directions.row(row++) = d.normalized().transpose();
  }
  return directions;
}

/// Planes that touch the hull of some points, along fixed directions and the points' own normals.
class Hull {
 public:
  Hull(const Points& vertices, const Points& normals, const PointIndices& points)
      : at_(static_cast<Eigen::Index>(points.size()), 3) {
    static const Points fixed = fixed_directions();
    directions_.resize(fixed.rows() + at_.rows(), 3);
    directions_.topRows(fixed.rows()) = fixed;
    for (Eigen::Index i = 0; i < at_.rows(); ++i) {
      at_.row(i) = vertices.row(points[static_cast<std::size_t>(i)]);
      directions_.row(fixed.rows() + i) = normals.row(points[static_cast<std::size_t>(i)]);
    }
    heights_ = (at_ * directions_.transpose()).colwise().maxCoeff();
  }

  bool holds(const Eigen::RowVector3f& p) const {
    for (Eigen::Index d = 0; d < directions_.rows(); ++d) {
      if (directions_.row(d).dot(p) >= heights_[d]) return false;
    }
    return true;
  }

  /// Depth of a point of a surface that faces along `normal` below the planes that face about the
  /// same way. [m]
  float depth(const Eigen::RowVector3f& p, const Eigen::RowVector3f& normal) const {
    constexpr float facing_alike = 0.5F;  // cosine
    float depth = (at_ * normal.transpose()).maxCoeff() - normal.dot(p);
    for (Eigen::Index d = 0; d < directions_.rows(); ++d) {
      if (directions_.row(d).dot(normal) > facing_alike)
        depth = std::min(depth, heights_[d] - directions_.row(d).dot(p));
    }
    return depth;
  }

 private:
  Points at_;
  Points directions_;
  Eigen::RowVectorXf heights_;
};

/// A graph of parts whose cheapest edge is contracted repeatedly.
class Clustering {
 public:
  explicit Clustering(const TriangleMesh& mesh) : mesh_(mesh), normals_(vertex_normals(mesh)) {
    const auto vertices = static_cast<Index>(mesh.vertices.rows());
    others_ = evenly_spread(vertices, std::min(vertices, other_samples));
    const auto count = static_cast<std::size_t>(mesh.triangles.rows());
    members_.resize(count);
    neighbors_.resize(count);
    alive_ = count;
    std::map<std::pair<Index, Index>, Index> first_at;
    for (Index t = 0; t < count; ++t) {
      for (int k = 0; k < 3; ++k) {
        members_[t].push_back(mesh.triangles(t, k));
        const auto [a, b] = std::minmax(mesh.triangles(t, k), mesh.triangles(t, (k + 1) % 3));
        const auto [other, is_new] = first_at.try_emplace({a, b}, t);
        if (is_new) continue;
        neighbors_[t].insert(other->second);
        neighbors_[other->second].insert(t);
      }
      std::sort(members_[t].begin(), members_[t].end());
    }
    for (Index t = 0; t < count; ++t) {
      for (const Index other : neighbors_[t]) {
        if (other > t) consider(t, other);
      }
    }
  }

  void join(double concavity, std::size_t max_parts) {
    while (alive_ > 1) {
      if (queue_.empty()) {
        if (alive_ <= max_parts) return;
        consider_nearest();
      }
      const auto [cost, a, b, version] = *queue_.begin();
      queue_.erase(queue_.begin());
      if (version != version_of(a, b)) continue;
      if (alive_ <= max_parts && depth(a, b) >= concavity) continue;
      contract(a, b);
    }
  }

  std::vector<PointIndices> parts() && {
    std::erase_if(members_, [](const PointIndices& part) { return part.empty(); });
    return std::move(members_);
  }

 private:
  using Candidate = std::tuple<double, Index, Index, std::size_t>;

  /// Changes whenever one of the two parts does, as parts only grow.
  std::size_t version_of(Index a, Index b) const {
    if (members_[a].empty() || members_[b].empty()) return 0;
    return members_[a].size() + members_[b].size();
  }

  double depth(Index a, Index b) const {
    return hollow_depth(mesh_.vertices, normals_, joined(members_[a], members_[b]), others_);
  }

  double extent(Index a, Index b) const {
    Box box;
    for (const Index part : {a, b}) {
      for (const Index v : members_[part]) {
        box.min = box.min.cwiseMin(mesh_.vertices.row(v).transpose());
        box.max = box.max.cwiseMax(mesh_.vertices.row(v).transpose());
      }
    }
    return box.extent().norm();
  }

  void consider(Index a, Index b) {
    if (a > b) std::swap(a, b);
    queue_.emplace(depth(a, b) + compactness * extent(a, b), a, b, version_of(a, b));
  }

  void contract(Index into, Index from) {
    members_[into] = joined(members_[into], members_[from]);
    members_[from].clear();
    --alive_;
    neighbors_[into].merge(neighbors_[from]);
    neighbors_[into].erase(into);
    neighbors_[into].erase(from);
    for (const Index other : neighbors_[into]) {
      neighbors_[other].erase(from);
      neighbors_[other].insert(into);
      consider(into, other);
    }
    neighbors_[from].clear();
  }

  /// Adds an edge between the smallest part and the part nearest to it, once no parts touch.
  void consider_nearest() {
    const auto has_fewer = [](const PointIndices& a, const PointIndices& b) {
      return !a.empty() && (b.empty() || a.size() < b.size());
    };
    const auto smallest = static_cast<Index>(
        std::min_element(members_.begin(), members_.end(), has_fewer) - members_.begin());
    const Eigen::Vector3d center = centroid(mesh_.vertices, members_[smallest]);
    Index nearest = smallest;
    double least = std::numeric_limits<double>::infinity();
    for (Index part = 0; part < members_.size(); ++part) {
      if (part == smallest || members_[part].empty()) continue;
      const double distance = (centroid(mesh_.vertices, members_[part]) - center).norm();
      if (distance < least) std::tie(nearest, least) = std::pair(part, distance);
    }
    neighbors_[smallest].insert(nearest);
    neighbors_[nearest].insert(smallest);
    consider(smallest, nearest);
  }

  const TriangleMesh& mesh_;
  Points normals_;
  PointIndices others_;
  std::vector<PointIndices> members_;  ///< of each part; empty once it is joined to another
  std::vector<std::set<Index>> neighbors_;
  std::set<Candidate> queue_;
  std::size_t alive_ = 0;
};

}  // namespace

double hollow_depth(const Points& vertices, const Points& normals, const PointIndices& part,
                    const PointIndices& others) {
  const auto size = static_cast<Index>(part.size());
  PointIndices chosen = evenly_spread(size, std::min(size, samples));
  for (Index& k : chosen) k = part[k];
  const Hull hull(vertices, normals, chosen);
  float deepest = 0.0F;
  for (const Index v : chosen)
    deepest = std::max(deepest, hull.depth(vertices.row(v), normals.row(v)));
  for (const Index v : others) {
    if (hull.holds(vertices.row(v)))
      deepest = std::max(deepest, hull.depth(vertices.row(v), normals.row(v)));
  }
  return deepest;
}

std::vector<PointIndices> cluster_convex(const TriangleMesh& mesh, double concavity,
                                         std::size_t max_parts) {
  Clustering clustering(mesh);
  clustering.join(concavity, max_parts);
  return std::move(clustering).parts();
}

}  // namespace symscene
