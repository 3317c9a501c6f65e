#include "reconstruction/point_to_plane.hpp"

#include <cmath>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"

namespace symscene {
namespace {

constexpr std::size_t lanes = 64;
constexpr std::size_t products = 27;  ///< upper half of J Jᵀ, then r J
constexpr std::size_t match_rows_per_task = 8;

SYMSCENE_MULTIVERSION
void add_products(const float (*j)[lanes], const float* r, const float* weight,
                  float (*__restrict product)[lanes]) {
  std::size_t k = 0;
  for (std::size_t a = 0; a < 6; ++a) {
    float weighted[lanes];
    for (std::size_t l = 0; l < lanes; ++l) weighted[l] = weight[l] * j[a][l];
    for (std::size_t b = a; b < 6; ++b, ++k) {
      for (std::size_t l = 0; l < lanes; ++l) product[k][l] += weighted[l] * j[b][l];
    }
    float* const side = product[products - 6 + a];
    for (std::size_t l = 0; l < lanes; ++l) side[l] += weighted[l] * r[l];
  }
}

}  // namespace

/// Sums over some rows of the image.
struct PointToPlaneMatcher::Sums {
  float product[products][lanes] = {};
  double folded[products] = {};
  double weight = 0.0;
  PoseFit fit;

  void fold() {
    for (std::size_t k = 0; k < products; ++k) {
      for (float& lane : product[k]) {
        folded[k] += lane;
        lane = 0.0F;
      }
    }
  }

  static Sums combined(Sums a, const Sums& b) {
    for (std::size_t k = 0; k < products; ++k) a.folded[k] += b.folded[k];
    a.weight += b.weight;
    a.fit += b.fit;
    return a;
  }

  NormalEquations equations() const {
    NormalEquations equations;
    std::size_t k = 0;
    for (int a = 0; a < 6; ++a) {
      for (int b = a; b < 6; ++b, ++k) equations.H(a, b) = equations.H(b, a) = folded[k];
    }
    equations.b = Eigen::Map<const Vector6d>(folded + products - 6);
    equations.weight = weight;
    equations.fit = fit;
    return equations;
  }
};

/// Matches waiting to be summed, lane by lane.
struct PointToPlaneMatcher::Batch {
  float j[6][lanes];  ///< p × n and n
  float r[lanes];     ///< n · (q − p)
  float weight[lanes];
  std::size_t size = 0;

  void add(const Eigen::Vector3f& turn, const Eigen::Vector3f& n, float residual, float w) {
    for (std::size_t a = 0; a < 3; ++a) {
      j[a][size] = turn[static_cast<Eigen::Index>(a)];
      j[a + 3][size] = n[static_cast<Eigen::Index>(a)];
    }
    r[size] = residual;
    weight[size] = w;
    ++size;
  }

  /// Adds the matches to `sums`; lanes without a match count nothing.
  void flush(Sums& sums) {
    if (size == 0) return;
    for (; size < lanes; ++size) {
      for (auto& component : j) component[size] = 0.0F;
      r[size] = weight[size] = 0.0F;
    }
    add_products(j, r, weight, sums.product);
    size = 0;
  }
};

PointToPlaneMatcher::PointToPlaneMatcher(const SurfaceImage& moved, const SurfaceImage& fixed,
                                         const MatchOptions& options)
    : association_(moved, fixed),
      noise_(options.noise),
      squared_distance_(static_cast<float>(options.max_distance * options.max_distance)),
      min_cosine_(static_cast<float>(std::cos(options.max_angle))),
      robust_sigmas_(static_cast<float>(options.robust_sigmas)) {}

NormalEquations PointToPlaneMatcher::match(const Eigen::Isometry3d& T_fixed_moved) const {
  return sum_rows<false>(T_fixed_moved.cast<float>());
}

NormalEquations PointToPlaneMatcher::match_constraints(
    const Eigen::Isometry3d& T_fixed_moved) const {
  return sum_rows<true>(T_fixed_moved.cast<float>());
}

double PointToPlaneMatcher::unit_weight() const {
  const auto deviation = static_cast<double>(noise_.deviation(1.0F, 1.0F));
  return 1.0 / (deviation * deviation);
}

template <bool constraints>
NormalEquations PointToPlaneMatcher::sum_rows(const Eigen::Isometry3f& T_fixed_moved) const {
  return reduce_blocks(
             association_.rows(), match_rows_per_task, Sums{},
             [&](std::size_t begin, std::size_t end) {
               Sums sums;
               for (std::size_t v = begin; v < end; ++v)
                 add_row<constraints>(v, T_fixed_moved, sums);
               sums.fold();
               return sums;
             },
             Sums::combined)
      .equations();
}

template <bool constraints>
void PointToPlaneMatcher::add_row(std::size_t v, const Eigen::Isometry3f& T_fixed_moved,
                                  Sums& sums) const {
  Batch batch;
  const std::size_t points =
      association_.for_each_pair(v, T_fixed_moved, [&](const ProjectivePair& pair) {
        sums.fit.shown += 1.0;
        if (!add_match<constraints>(pair, T_fixed_moved, batch, sums)) return;
        if (batch.size == lanes) batch.flush(sums);
      });
  sums.fit.points += static_cast<double>(points);
  batch.flush(sums);
}

template <bool constraints>
bool PointToPlaneMatcher::add_match(const ProjectivePair& pair,
                                    const Eigen::Isometry3f& T_fixed_moved, Batch& batch,
                                    Sums& sums) const {
  const Eigen::Vector3f& p = pair.moved_point;
  const Eigen::Vector3f n(pair.fixed.nx, pair.fixed.ny, pair.fixed.nz);
  const Eigen::Vector3f m =
      T_fixed_moved.linear() * Eigen::Vector3f(pair.moved.nx, pair.moved.ny, pair.moved.nz);
  const Eigen::Vector3f gap = pair.fixed_point - p;
  if (gap.squaredNorm() > squared_distance_ || m.dot(n) < min_cosine_) return false;
  const float r = n.dot(gap);
  const float deviation = noise_.deviation(pair.moved.depth, pair.fixed.depth);
  const float ratio = r / (robust_sigmas_ * deviation);
  const float robust = 1.0F / (1.0F + ratio * ratio);
  // Relative to the deviation at 1 m, which keeps the sums near 1 in single precision.
  const float scale = noise_.deviation(1.0F, 1.0F) / deviation;
  const float weight = robust * scale * scale;
  if constexpr (constraints) {
    // ½ (n mᵀ + m nᵀ) = ¼ (n + m)(n + m)ᵀ − ¼ (n − m)(n − m)ᵀ, each normal with its own point: half
    // a pixel between them would count as a constraint, even on rotations of a ball.
    const Eigen::Vector3f turn_n = pair.fixed_point.cross(n), turn_m = p.cross(m);
    batch.add(0.5F * (turn_n + turn_m), 0.5F * (n + m), 0.0F, weight);
    batch.add(0.5F * (turn_n - turn_m), 0.5F * (n - m), 0.0F, -weight);
  } else {
    batch.add(p.cross(n), n, r, weight);
  }
  sums.weight += static_cast<double>(weight);
  sums.fit.matches += 1.0;
  if (std::abs(r) < inlier_sigmas * deviation) {
    sums.fit.inliers += 1.0;
    sums.fit.squares += static_cast<double>(r) * static_cast<double>(r);
  }
  return true;
}

}  // namespace symscene
