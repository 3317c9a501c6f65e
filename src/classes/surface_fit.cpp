#include "surface_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

#include "core/median.hpp"

namespace symscene {
namespace {

constexpr int scale_rounds = 4;
constexpr int steps_per_round = 4;
constexpr double loss_width = 2.5;        // of the Geman-McClure loss, in standard deviations
constexpr double normal_median = 1.4826;  // standard deviation over median of |residual|
constexpr double least_eigenvalue = 1e-7;

/// A sample on a face.
struct Assigned {
  int face = 0;
  Eigen::Vector3d local;
  double distance = 0.0;  ///< [m]
};

std::vector<Assigned> assigned_samples(const SurfaceModel& model, const FitSamples& samples,
                                       const FitBounds& bounds) {
  std::vector<Assigned> assigned;
  assigned.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d local = model.to_local(samples.positions[i]);
    const Eigen::Vector3d normal = model.axes.transpose() * samples.normals[i];
    const std::optional<int> face = nearest_face(model, local, normal, bounds.face_cosine);
    if (face) assigned.push_back({*face, local, model.distance(*face, local)});
  }
  return assigned;
}

double scale_of(const std::vector<Assigned>& assigned, double min_scale) {
  std::vector<double> distances;
  for (const Assigned& sample : assigned) distances.push_back(std::abs(sample.distance));
  return std::max(min_scale, normal_median * median(std::move(distances)).value_or(0.0));
}

/// Geman-McClure with a constant share for samples on no face.
double loss(double distance, double width) {
  const double squared = distance * distance;
  return squared / (squared + width * width);
}

double total_loss(const std::vector<Assigned>& assigned, std::size_t samples, double width) {
  double sum = static_cast<double>(samples - assigned.size());
  for (const Assigned& sample : assigned) sum += loss(sample.distance, width);
  return sum;
}

/// Normal equations of the weighted distances in the active parameters.
struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
  std::vector<Eigen::Index> active;

  NormalEquations(const SurfaceModel& model, const std::vector<Assigned>& assigned, double width) {
    const std::array<bool, 13> is_active = model.active();
    for (std::size_t k = 0; k < is_active.size(); ++k) {
      if (is_active[k]) active.push_back(static_cast<Eigen::Index>(k));
    }
    const auto count = static_cast<Eigen::Index>(active.size());
    Eigen::Matrix<double, 13, 13> full = Eigen::Matrix<double, 13, 13>::Zero();
    SurfaceStep full_right = SurfaceStep::Zero();
    for (const Assigned& sample : assigned) {
      const double share = width * width / (sample.distance * sample.distance + width * width);
      const double weight = share * share;
      const SurfaceStep gradient = distance_gradient(model, sample.face, sample.local);
      full.noalias() += (weight * gradient) * gradient.transpose();
      full_right -= weight * sample.distance * gradient;
    }
    matrix.resize(count, count);
    right.resize(count);
    for (Eigen::Index a = 0; a < count; ++a) {
      right[a] = full_right[active[static_cast<std::size_t>(a)]];
      for (Eigen::Index b = 0; b < count; ++b)
        matrix(a, b) =
            full(active[static_cast<std::size_t>(a)], active[static_cast<std::size_t>(b)]);
    }
  }

  SurfaceStep step(double damping) const {
    Eigen::MatrixXd damped = matrix;
    damped.diagonal() *= 1.0 + damping;
    const Eigen::VectorXd solved = damped.ldlt().solve(right);
    SurfaceStep step = SurfaceStep::Zero();
    for (std::size_t a = 0; a < active.size(); ++a)
      step[active[a]] = solved[static_cast<Eigen::Index>(a)];
    return step;
  }

  /// The inverse, with parameters scaled to one; none where a direction is not determined.
  std::optional<Eigen::MatrixXd> inverse() const {
    const Eigen::VectorXd diagonal = matrix.diagonal();
    if (!(diagonal.minCoeff() > 0.0)) return std::nullopt;
    const Eigen::VectorXd units = diagonal.cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = units.asDiagonal() * matrix * units.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
    if (eigen.eigenvalues()[0] < least_eigenvalue) return std::nullopt;
    return units.asDiagonal() * eigen.eigenvectors() *
           eigen.eigenvalues().cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose() *
           units.asDiagonal();
  }
};

/// Steps at a fixed width of the loss, until one lowers it no more.
void descend(SurfaceModel& model, std::vector<Assigned>& assigned, const FitSamples& samples,
             const FitBounds& bounds, double width) {
  double damping = 1e-4;
  double cost = total_loss(assigned, samples.size(), width);
  for (int k = 0; k < steps_per_round; ++k) {
    const SurfaceStep step = NormalEquations(model, assigned, width).step(damping);
    if (!step.allFinite()) return;
    SurfaceModel moved = model;
    moved.move(step);
    std::vector<Assigned> again = assigned_samples(moved, samples, bounds);
    const double moved_cost = total_loss(again, samples.size(), width);
    if (!(moved_cost <= cost)) {
      damping *= 100.0;
      continue;
    }
    const bool is_still = cost - moved_cost < 1e-6 * cost;
    model = moved;
    assigned = std::move(again);
    cost = moved_cost;
    if (is_still) return;
  }
}

/// The offset that most of the values are near, the outermost of several.
double densest_offset(std::vector<double> values, double width) {
  std::sort(values.begin(), values.end());
  std::size_t best = 0, best_begin = 0, begin = 0;
  for (std::size_t end = 0; end < values.size(); ++end) {
    while (values[end] - values[begin] > width) ++begin;
    if (end - begin + 1 < best) continue;
    best = end - begin + 1;
    best_begin = begin;
  }
  return values[best_begin + best / 2];
}

/// Share and residual of the explained samples, and the Bayesian information criterion, in which a
/// sample that is not explained counts as twice the tolerance off the surface.
void judge_fit(SurfaceFit& fit, const FitSamples& samples, const FitBounds& bounds) {
  const double outside = 2.0 * bounds.tolerance;
  double squares = 0.0, all_squares = 0.0;
  std::size_t explained = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!is_explained(fit.model, samples.positions[i], samples.normals[i], bounds.tolerance)) {
      all_squares += outside * outside;
      continue;
    }
    const double distance = signed_distance(fit.model, fit.model.to_local(samples.positions[i]));
    squares += distance * distance;
    all_squares += distance * distance;
    ++explained;
  }
  const auto count = static_cast<double>(samples.size());
  fit.explained = static_cast<double>(explained) / count;
  fit.residual = std::sqrt(squares / std::max(1.0, static_cast<double>(explained)));
  const std::array<bool, 13> is_active = fit.model.active();
  const auto parameters = static_cast<double>(std::count(is_active.begin(), is_active.end(), true));
  const double variance = all_squares / count + bounds.min_scale * bounds.min_scale;
  const double independent = std::max(2.0, count / bounds.correlated);
  fit.criterion = independent * std::log(variance) + parameters * std::log(independent);
}

}  // namespace

std::optional<int> nearest_face(const SurfaceModel& model, const Eigen::Vector3d& local,
                                const Eigen::Vector3d& normal, double face_cosine) {
  std::optional<int> nearest;
  double best = face_cosine;
  for (int f = 0; f < model.faces(); ++f) {
    if (!model.has_face(f)) continue;
    const double cosine = normal.dot(model.normal(f, local));
    if (cosine < best) continue;
    best = cosine;
    nearest = f;
  }
  return nearest;
}

double signed_distance(const SurfaceModel& model, const Eigen::Vector3d& local) {
  double distance = -1e30;
  for (int f = 0; f < model.faces(); ++f) {
    if (model.has_face(f)) distance = std::max(distance, model.distance(f, local));
  }
  return distance;
}

bool is_explained(const SurfaceModel& model, const Eigen::Vector3d& point,
                  const Eigen::Vector3d& normal, double tolerance) {
  constexpr double least_cosine = 0.3;
  const Eigen::Vector3d local = model.to_local(point);
  const double distance = signed_distance(model, local);
  if (std::abs(distance) > tolerance) return false;
  const Eigen::Vector3d local_normal = model.axes.transpose() * normal;
  for (int f = 0; f < model.faces(); ++f) {
    if (model.has_face(f) && model.distance(f, local) >= distance - tolerance &&
        local_normal.dot(model.normal(f, local)) > least_cosine)
      return true;
  }
  return false;
}

void place_planar_faces(SurfaceModel& model, const FitSamples& samples, const FitBounds& bounds) {
  constexpr double most_beyond = 0.06;  // share of the samples beyond a face
  const auto count = static_cast<double>(samples.size());
  for (int f = 2 * model.first_axis(); f < SurfaceModel::planar_faces; ++f) {
    const Eigen::Vector3d normal = model.axes * SurfaceModel::planar_normal(f);
    std::vector<double> on_face;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (normal.dot(samples.normals[i]) > bounds.face_cosine)
        on_face.push_back(normal.dot(samples.positions[i] - model.origin));
    }
    const auto at = static_cast<std::size_t>(f);
    model.present[at] = false;
    if (static_cast<double>(on_face.size()) < std::max(8.0, bounds.min_face_share * count))
      continue;
    const double offset = densest_offset(on_face, bounds.tolerance);
    const auto near = std::count_if(on_face.begin(), on_face.end(), [&](double value) {
      return std::abs(value - offset) < bounds.tolerance;
    });
    if (static_cast<double>(near) < std::max(8.0, bounds.min_face_share * count)) continue;
    const auto beyond = std::count_if(
        samples.positions.begin(), samples.positions.end(), [&](const Eigen::Vector3d& p) {
          return normal.dot(p - model.origin) > offset + bounds.tolerance;
        });
    if (static_cast<double>(beyond) > most_beyond * count) continue;
    model.offsets[at] = offset;
    model.present[at] = true;
  }
}

std::optional<SurfaceFit> fit_surface(const SurfaceModel& initial, const FitSamples& samples,
                                      const FitBounds& bounds) {
  SurfaceFit fit;
  fit.model = initial;
  std::vector<Assigned> assigned = assigned_samples(fit.model, samples, bounds);
  for (int round = 0; round < scale_rounds; ++round) {
    if (4 * assigned.size() < samples.size()) return std::nullopt;
    fit.scale = scale_of(assigned, bounds.min_scale);
    descend(fit.model, assigned, samples, bounds, loss_width * fit.scale);
  }
  fit.scale = scale_of(assigned, bounds.min_scale);
  const NormalEquations equations(fit.model, assigned, loss_width * fit.scale);
  const std::optional<Eigen::MatrixXd> inverse = equations.inverse();
  if (!inverse) return std::nullopt;
  for (std::size_t a = 0; a < equations.active.size(); ++a) {
    for (std::size_t b = 0; b < equations.active.size(); ++b)
      fit.covariance(equations.active[a], equations.active[b]) =
          fit.scale * fit.scale *
          (*inverse)(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
  }
  judge_fit(fit, samples, bounds);
  return fit;
}

}  // namespace symscene
