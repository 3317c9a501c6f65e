#include "plane_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"

namespace symscene {
namespace {

constexpr std::size_t refined_hypotheses = 8;
constexpr std::size_t hypothesis_refinements = 3;

/// Points and normals as arrays, for loops that vectorise.
struct OrientedSample {
  std::vector<float> x, y, z, nx, ny, nz;

  std::size_t size() const { return x.size(); }
  void add(const Eigen::Vector3f& p, const Eigen::Vector3f& n) {
    x.push_back(p.x());
    y.push_back(p.y());
    z.push_back(p.z());
    nx.push_back(n.x());
    ny.push_back(n.y());
    nz.push_back(n.z());
  }
  Eigen::Vector3f position(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Eigen::Vector3f normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
};

struct InlierTest {
  float a, b, c, d;
  float distance;
  float cosine;
};

SYMSCENE_MULTIVERSION
int count_inliers(const OrientedSample& sample, const InlierTest& test) {
  const InlierTest t = test;
  const float *x = sample.x.data(), *y = sample.y.data(), *z = sample.z.data();
  const float *nx = sample.nx.data(), *ny = sample.ny.data(), *nz = sample.nz.data();
  const std::size_t count = sample.size();
  int inliers = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float distance = t.a * x[i] + t.b * y[i] + t.c * z[i] + t.d;
    const float cosine = t.a * nx[i] + t.b * ny[i] + t.c * nz[i];
    const bool near = (distance < t.distance) & (distance > -t.distance);
    const bool inlier = near & (cosine > t.cosine);
    inliers += inlier ? 1 : 0;
  }
  return inliers;
}

class PlaneSearch {
 public:
  PlaneSearch(OrientedSample sample, const SupportPlaneOptions& options)
      : sample_(std::move(sample)),
        options_(options),
        random_(options.seed),
        least_(static_cast<int>(options.min_share * static_cast<double>(sample_.size())) + 3) {}

  std::optional<Plane> next() {
    if (sample_.size() < 3) return std::nullopt;
    Counted best{{}, 0};
    for (const Counted& start : promising()) {
      const Counted fitted = refined(start.plane);
      if (fitted.inliers > best.inliers) best = fitted;
    }
    if (best.inliers < least_) return std::nullopt;
    remove_inliers(best.plane);
    return best.plane;
  }

 private:
  struct Counted {
    Plane plane;
    int inliers;
  };

  InlierTest test(const Plane& plane, double distance) const {
    return {
        static_cast<float>(plane.normal.x()), static_cast<float>(plane.normal.y()),
        static_cast<float>(plane.normal.z()), static_cast<float>(plane.offset),
        static_cast<float>(distance),         static_cast<float>(std::cos(options_.normal_angle))};
  }

  int count(const Plane& plane, double distance) const {
    return count_inliers(sample_, test(plane, distance));
  }

  bool is_inlier(std::size_t i, const Plane& plane, double distance) const {
    return std::abs(plane.signed_distance(sample_.position(i).cast<double>())) < distance &&
           plane.normal.dot(sample_.normal(i).cast<double>()) > std::cos(options_.normal_angle);
  }

  /// The hypotheses, each from one point and its normal, with most inliers.
  std::vector<Counted> promising() {
    std::vector<Counted> tried;
    for (int k = 0; k < options_.hypotheses; ++k) {
      const std::size_t i = random_.below(static_cast<std::uint32_t>(sample_.size()));
      Plane plane;
      plane.normal = sample_.normal(i).cast<double>().normalized();
      plane.offset = -plane.normal.dot(sample_.position(i).cast<double>());
      tried.push_back({plane, 0});
    }
    constexpr std::size_t block = 32;
    parallel_for_blocks(tried.size(), block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        tried[k].inliers = count(tried[k].plane, options_.coarse_factor * options_.inlier_distance);
    });
    std::stable_sort(tried.begin(), tried.end(),
                     [](const Counted& a, const Counted& b) { return a.inliers > b.inliers; });
    tried.resize(std::min(tried.size(), refined_hypotheses));
    return tried;
  }

  Counted refined(Plane plane) const {
    double distance = options_.coarse_factor * options_.inlier_distance;
    for (std::size_t round = 0; round < hypothesis_refinements; ++round) {
      PlaneMoments moments;
      for (std::size_t i = 0; i < sample_.size(); ++i) {
        if (is_inlier(i, plane, distance)) moments.add(sample_.position(i).cast<double>());
      }
      plane = moments.plane(plane);
      distance = options_.inlier_distance;
    }
    return {plane, count(plane, options_.inlier_distance)};
  }

  void remove_inliers(const Plane& plane) {
    OrientedSample kept;
    for (std::size_t i = 0; i < sample_.size(); ++i) {
      if (is_inlier(i, plane, 2.0 * options_.inlier_distance)) continue;
      kept.add(sample_.position(i), sample_.normal(i));
    }
    sample_ = std::move(kept);
  }

  OrientedSample sample_;
  const SupportPlaneOptions& options_;
  Random random_;
  int least_;
};

}  // namespace

PlaneMoments PlaneMoments::operator+(const PlaneMoments& other) const {
  PlaneMoments sum = *this;
  sum.count_ += other.count_;
  sum.sum_ += other.sum_;
  sum.squares_ += other.squares_;
  return sum;
}

Plane PlaneMoments::plane(const Plane& fallback) const {
  if (count_ < 3) return fallback;
  const Eigen::Vector3d mean = sum_ / static_cast<double>(count_);
  const Eigen::Matrix3d covariance =
      squares_ / static_cast<double>(count_) - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  if (!(solver.eigenvalues()[1] > 1e-8)) return fallback;
  Plane plane;
  plane.normal = solver.eigenvectors().col(0);
  if (plane.normal.dot(fallback.normal) < 0.0) plane.normal = -plane.normal;
  plane.offset = -plane.normal.dot(mean);
  return plane;
}

double PlaneMoments::residual(const Plane& plane) const {
  if (count_ == 0) return 0.0;
  const Eigen::Vector3d mean = sum_ / static_cast<double>(count_);
  const double along = plane.normal.dot(squares_ * plane.normal) / static_cast<double>(count_);
  const double distance = plane.normal.dot(mean);
  const double square = along + 2.0 * plane.offset * distance + plane.offset * plane.offset;
  return std::sqrt(std::max(square, 0.0));
}

std::vector<Plane> dominant_planes(const PointCloud& cloud, const PointIndices& usable,
                                   const SupportPlaneOptions& options) {
  std::vector<Plane> planes;
  if (usable.empty()) return planes;
  OrientedSample sample;
  Random random(options.seed, 1);
  const std::size_t size = std::min(usable.size(), static_cast<std::size_t>(options.sample));
  for (std::size_t k = 0; k < size; ++k) {
    const Index i = size == usable.size()
                        ? usable[k]
                        : usable[random.below(static_cast<std::uint32_t>(usable.size()))];
    sample.add(cloud.position(i), cloud.normal(i));
  }
  PlaneSearch search(std::move(sample), options);
  while (planes.size() < static_cast<std::size_t>(options.max_planes)) {
    const std::optional<Plane> plane = search.next();
    if (!plane) break;
    planes.push_back(*plane);
  }
  return planes;
}

}  // namespace symscene
