#include "symmetry/axis_fit.hpp"

#include <cmath>

#include <Eigen/Dense>

namespace symscene {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t min_points = 8;

/// The points of a fit, centred and in double.
struct FitPoints {
  Eigen::Vector3d centroid;
  std::vector<Eigen::Vector3d> positions;  ///< from the centroid
  std::vector<Eigen::Vector3d> normals;
};

FitPoints thinned(const PointCloud& cloud, int max_points) {
  FitPoints points;
  points.centroid = centroid(cloud.positions);
  for (const Index i : evenly_spread(cloud.size(), static_cast<Index>(max_points))) {
    points.positions.emplace_back(cloud.position(i).cast<double>() - points.centroid);
    points.normals.emplace_back(cloud.normal(i).cast<double>());
  }
  return points;
}

struct NormalEquations {
  Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();  ///< lower triangle

  void add(const Eigen::Vector4d& jacobian, double weight, double residual) {
    for (int column = 0; column < 4; ++column) {
      for (int row = column; row < 4; ++row)
        hessian(row, column) += weight * jacobian[row] * jacobian[column];
    }
    gradient += weight * residual * jacobian;
  }
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
  double cost = 0.0;
};

constexpr std::size_t lanes = 16;
using Lanes = Eigen::Array<double, static_cast<int>(lanes), 1>;

/// A vector for each point of a block.
struct VectorLanes {
  Lanes x, y, z;

  void set(std::size_t k, const Eigen::Vector3d& vector) {
    const auto lane = static_cast<Eigen::Index>(k);
    x[lane] = vector.x();
    y[lane] = vector.y();
    z[lane] = vector.z();
  }
};

VectorLanes cross(const VectorLanes& a, const VectorLanes& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Lanes dot(const VectorLanes& a, const VectorLanes& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

VectorLanes repeated(const Eigen::Vector3d& vector) {
  return {Lanes::Constant(vector.x()), Lanes::Constant(vector.y()), Lanes::Constant(vector.z())};
}

/// Consecutive points, whose residuals are computed at once.
struct PointBlock {
  VectorLanes positions, normals;
  std::size_t count = 0;
};

std::vector<PointBlock> blocks_of(const FitPoints& points) {
  std::vector<PointBlock> blocks((points.positions.size() + lanes - 1) / lanes);
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    PointBlock& block = blocks[i / lanes];
    block.positions.set(i % lanes, points.positions[i]);
    block.normals.set(i % lanes, points.normals[i]);
    block.count = i % lanes + 1;
  }
  // The rest of the last block is not used; its values are any finite ones.
  if (!blocks.empty()) {
    for (std::size_t k = blocks.back().count; k < lanes; ++k) {
      blocks.back().positions.set(k, Eigen::Vector3d::Zero());
      blocks.back().normals.set(k, Eigen::Vector3d::Zero());
    }
  }
  return blocks;
}

/// Geman-McClure: ρ = r²/(r² + σ²) and its weight ρ'/2r.
struct RobustLoss {
  double squared_scale;
  Lanes cost(const Lanes& r) const { return r * r / (r * r + squared_scale); }
  Lanes weight(const Lanes& r) const {
    const Lanes sum = r * r + squared_scale;
    return squared_scale / (sum * sum);
  }
};

class AxisProblem {
 public:
  AxisProblem(const FitPoints& points, const AxisFitOptions& options)
      : blocks_(blocks_of(points)),
        size_(static_cast<double>(points.positions.size())),
        loss_{std::pow(std::sin(options.residual_scale), 2)},
        squared_noise_(options.position_noise * options.position_noise) {}

  /// With the axis moved by basis·(a, b) in direction and basis·(c, d) in position.
  NormalEquations normal_equations(const RotationAxis& axis,
                                   const Eigen::Matrix<double, 3, 2>& basis) const {
    NormalEquations equations;
    for (const PointBlock& block : blocks_) add(block, axis, basis, equations);
    equations.cost /= size_;
    return equations;
  }

 private:
  /// Adds the points of a block, in order, except those on the axis. The residual of a point is the
  /// sine of the angle of Fig. 3.4: r = n · u with u the unit normal of the plane through axis and
  /// point.
  void add(const PointBlock& block, const RotationAxis& axis,
           const Eigen::Matrix<double, 3, 2>& basis, NormalEquations& equations) const {
    const VectorLanes direction = repeated(axis.direction), point = repeated(axis.point);
    const VectorLanes first = repeated(basis.col(0)), second = repeated(basis.col(1));
    const VectorLanes &p = block.positions, &n = block.normals;
    const VectorLanes q{p.x - point.x, p.y - point.y, p.z - point.z};
    const VectorLanes across = cross(direction, q);
    const Lanes length = dot(across, across).sqrt();
    const VectorLanes u{across.x / length, across.y / length, across.z / length};
    const Lanes sine = dot(n, u);
    // dr = g · (δd × q − d × δc) = δd · (q × g) − δc · (g × d)
    const VectorLanes g{(n.x - sine * u.x) / length, (n.y - sine * u.y) / length,
                        (n.z - sine * u.z) / length};
    const VectorLanes turn = cross(q, g), shift = cross(g, direction);
    const Lanes a = dot(first, turn), b = dot(second, turn);
    const Lanes c = -dot(first, shift), d = -dot(second, shift);
    const Lanes proximity = proximity_weight(length);
    const Lanes weight = proximity * loss_.weight(sine), cost = proximity * loss_.cost(sine);
    for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(block.count); ++k) {
      if (length[k] < 1e-9) continue;
      equations.add({a[k], b[k], c[k], d[k]}, weight[k], sine[k]);
      equations.cost += cost[k];
    }
  }

  /// Noise in a position turns the plane of a point near the axis, so that its angle has less
  /// weight.
  Lanes proximity_weight(const Lanes& length) const {
    const Lanes squared = length * length;
    return squared / (squared + 4.0 * squared_noise_);
  }

  std::vector<PointBlock> blocks_;
  double size_;
  RobustLoss loss_;
  double squared_noise_;
};

/// The axis after a step; its point is brought back to the foot of the origin, the centroid.
RotationAxis moved(const RotationAxis& axis, const Eigen::Matrix<double, 3, 2>& basis,
                   const Eigen::Vector4d& step) {
  RotationAxis result;
  result.direction = (axis.direction + basis * step.head<2>()).normalized();
  result.point = axis.point + basis * step.tail<2>();
  result.point = result.project(Eigen::Vector3d::Zero());
  return result;
}

/// The axis of known direction that the lines of the normals come nearest to: n · (d × (p − c)) =
/// 0, linear in c.
RotationAxis place_axis(const FitPoints& points, const Eigen::Vector3d& direction) {
  const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(direction);
  Eigen::Matrix2d normal_matrix = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right_side = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const Eigen::Vector2d a = basis.transpose() * points.normals[i].cross(direction);
    normal_matrix += a * a.transpose();
    right_side += a * a.dot(basis.transpose() * points.positions[i]);
  }
  // A flat patch does not determine one direction: the axis stays near the centroid there.
  const double hold = 1e-6 * static_cast<double>(points.positions.size());
  normal_matrix += hold * Eigen::Matrix2d::Identity();
  return {basis * normal_matrix.ldlt().solve(right_side), direction};
}

/// The direction of the helical motion under which the surface is most nearly invariant (Pottmann
/// and Randrup 1998): with velocity v + ω × p, minimises Σ (n · v + (p × n) · ω)² over |ω| = 1, v
/// eliminated.
Eigen::Vector3d invariant_motion_direction(const FitPoints& points) {
  Matrix6d matrix = Matrix6d::Zero();
  double squared_size = 0.0;
  for (const Eigen::Vector3d& p : points.positions) squared_size += p.squaredNorm();
  const double size =
      std::sqrt(squared_size / static_cast<double>(points.positions.size())) + 1e-12;
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    Vector6d row;
    row << points.positions[i].cross(points.normals[i]) / size, points.normals[i];
    matrix += row * row.transpose();
  }
  const double hold = 1e-4 * static_cast<double>(points.positions.size());
  const Eigen::Matrix3d vv = matrix.bottomRightCorner<3, 3>() + hold * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d wv = matrix.topRightCorner<3, 3>();
  const Eigen::Matrix3d schur = matrix.topLeftCorner<3, 3>() - wv * vv.ldlt().solve(wv.transpose());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(schur).eigenvectors().col(0);
}

RotationAxis translated(RotationAxis axis, const Eigen::Vector3d& offset) {
  axis.point += offset;
  return axis;
}

}  // namespace

AxisFit fit_axis(const PointCloud& cloud, const RotationAxis& initial,
                 const AxisFitOptions& options) {
  options.validate();
  if (cloud.size() < min_points) return {initial, 1.0, FitStatus::too_few_points};
  const FitPoints points = thinned(cloud, options.max_points);
  const AxisProblem problem(points, options);
  RotationAxis axis = translated(initial, -points.centroid);
  axis.point = axis.project(Eigen::Vector3d::Zero());
  FitStatus status = FitStatus::iteration_limit;
  double damping = 1e-3;
  Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(axis.direction);
  NormalEquations equations = problem.normal_equations(axis, basis);
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    Eigen::Matrix4d damped = equations.hessian;
    damped.diagonal() *= 1.0 + damping;
    damped.diagonal().array() += 1e-12;
    const Eigen::Vector4d step = damped.ldlt().solve(-equations.gradient);
    if (!step.allFinite()) {
      status = FitStatus::degenerate;
      break;
    }
    const RotationAxis candidate = moved(axis, basis, step);
    const Eigen::Matrix<double, 3, 2> candidate_basis = orthonormal_complement(candidate.direction);
    const NormalEquations at_candidate = problem.normal_equations(candidate, candidate_basis);
    const bool settled = step.head<2>().norm() < options.angle_tolerance &&
                         step.tail<2>().norm() < options.distance_tolerance;
    if (at_candidate.cost < equations.cost) {
      axis = candidate;
      basis = candidate_basis;
      equations = at_candidate;
      damping = std::max(damping * 0.3, 1e-9);
    } else {
      damping *= 10.0;
    }
    if (settled || damping > 1e6) {
      status = FitStatus::converged;
      break;
    }
  }
  return {translated(axis, points.centroid), equations.cost, status};
}

std::vector<RotationAxis> initial_axes(const PointCloud& cloud,
                                       const std::vector<Eigen::Vector3d>& more_directions,
                                       const AxisFitOptions& options) {
  options.validate();
  if (cloud.size() < min_points) return {};
  const FitPoints points = thinned(cloud, options.max_points);
  const Eigen::Matrix3d principal = principal_axes(cloud.positions);
  std::vector<Eigen::Vector3d> directions{invariant_motion_direction(points), principal.col(0),
                                          principal.col(1), principal.col(2)};
  directions.insert(directions.end(), more_directions.begin(), more_directions.end());
  std::vector<RotationAxis> axes;
  for (const Eigen::Vector3d& direction : directions) {
    axes.push_back(translated(place_axis(points, direction), points.centroid));
  }
  return axes;
}

}  // namespace symscene
