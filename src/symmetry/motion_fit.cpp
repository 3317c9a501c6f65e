#include "motion_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace symscene {
namespace {

constexpr double converged = 1e-5;

/// The steps of a fit. The scale of the robust weights shrinks with each step; it is relative to
/// the diameter.
struct Schedule {
  int steps;
  double first_scale, cooling, last_scale;

  double scale(int step) const {
    return std::max(last_scale, first_scale * std::pow(cooling, step));
  }
};
constexpr Schedule coarse_schedule{12, 0.05, 0.8, 0.02};
constexpr Schedule exact_schedule{10, 0.02, 0.8, 0.01};

/// Takes steps at shrinking scales until they are small at the last one. `step_at(scale)` returns
/// the length of its step.
template <class Step>
void descend(Matching matching, const Step& step_at) {
  const Schedule& schedule = matching == Matching::coarse ? coarse_schedule : exact_schedule;
  for (int k = 0; k < schedule.steps; ++k) {
    const double scale = schedule.scale(k);
    if (step_at(scale) < converged && scale == schedule.last_scale) return;
  }
}

/// Directions that the surface leaves open (a face slid in its own plane) stay where they are.
constexpr double damping = 1e-4;

/// Weighted normal equations of a step in `n` parameters.
template <int n>
class Equations {
 public:
  using Vector = Eigen::Matrix<double, n, 1>;

  void add(const Vector& jacobian, double residual, double weight) {
    hessian_ += weight * jacobian * jacobian.transpose();
    gradient_ += weight * residual * jacobian;
    weights_ += weight;
  }
  Vector step() const {
    Eigen::Matrix<double, n, n> damped = hessian_;
    damped.diagonal().array() += std::max(damping * weights_, 1e-12);
    return damped.ldlt().solve(-gradient_);
  }

 private:
  Eigen::Matrix<double, n, n> hessian_ = Eigen::Matrix<double, n, n>::Zero();
  Vector gradient_ = Vector::Zero();
  double weights_ = 0.0;
};

/// Where a moved sample meets the surface.
struct Contact {
  Eigen::Vector3d normal;
  double residual;  ///< from the tangent plane [m]
  double weight;
};

SurfaceDistance::Match match_of(const SurfaceDistance& surface, const Eigen::Vector3f& point,
                                Matching matching) {
  return matching == Matching::coarse ? surface.coarse(point) : surface.nearest(point);
}

Contact contact_at(const SurfaceDistance& surface, const Eigen::Vector3d& moved, double scale,
                   Matching matching) {
  const SurfaceDistance::Match match = match_of(surface, moved.cast<float>(), matching);
  const Eigen::Vector3d normal = surface.samples().normal(match.sample).cast<double>();
  const Eigen::Vector3d at = surface.samples().position(match.sample).cast<double>();
  const double ratio = match.distance / scale;
  return {normal, normal.dot(moved - at), 1.0 / (1.0 + ratio * ratio)};
}

}  // namespace

Eigen::Affine3d motion_of(const ReflectionPlane& plane) {
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.linear() -= 2.0 * plane.normal * plane.normal.transpose();
  motion.translation() = 2.0 * plane.normal.dot(plane.point) * plane.normal;
  return motion;
}

Eigen::Affine3d motion_of(const RotationAxis& axis, double angle) {
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.linear() = axis.rotation(angle);
  motion.translation() = axis.point - motion.linear() * axis.point;
  return motion;
}

double mean_distance(const SurfaceDistance& surface, std::span<const Index> samples,
                     const Eigen::Affine3d& motion, Matching matching) {
  const Eigen::Affine3f by = motion.cast<float>();
  double sum = 0.0;
  for (const Index i : samples)
    sum += double{match_of(surface, by * surface.samples().position(i), matching).distance};
  return sum / static_cast<double>(samples.size());
}

double mean_distance(const SurfaceDistance& surface, std::span<const Index> samples,
                     const RotationAxis& axis, std::span<const double> angles, Matching matching) {
  double worst = 0.0;
  for (const double angle : angles)
    worst = std::max(worst, mean_distance(surface, samples, motion_of(axis, angle), matching));
  return worst;
}

double share_beyond(const SurfaceDistance& surface, std::span<const Index> samples,
                    const Eigen::Affine3d& motion, double distance) {
  const Eigen::Affine3f by = motion.cast<float>();
  const auto beyond = std::count_if(samples.begin(), samples.end(), [&](Index i) {
    return surface.nearest(by * surface.samples().position(i)).distance > distance;
  });
  return static_cast<double>(beyond) / static_cast<double>(samples.size());
}

ReflectionPlane fit_to(const SurfaceDistance& surface, std::span<const Index> samples,
                       const ReflectionPlane& start, Matching matching) {
  ReflectionPlane plane = start;
  descend(matching, [&](double scale) {
    const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(plane.normal);
    Equations<3> equations;
    for (const Index i : samples) {
      const Eigen::Vector3d p = surface.samples().position(i).cast<double>() - plane.point;
      const double distance = plane.normal.dot(p);
      const Eigen::Vector3d moved = p - 2.0 * distance * plane.normal;
      const Contact contact = contact_at(surface, plane.point + moved, scale, matching);
      // x' = x − 2 (n · x − o) n, so that d(m · x') = −2 [(m · n)(x · δn − δo) + (n · x)(m · δn)]
      const double cosine = contact.normal.dot(plane.normal);
      Eigen::Vector3d jacobian;
      jacobian << -2.0 * basis.transpose() * (cosine * p + distance * contact.normal), 2.0 * cosine;
      equations.add(jacobian, contact.residual, contact.weight);
    }
    const Eigen::Vector3d step = equations.step();
    plane.point += step.z() * plane.normal;
    plane.normal = (plane.normal + basis * step.head<2>()).normalized();
    return step.norm();
  });
  return plane;
}

RotationAxis fit_to(const SurfaceDistance& surface, std::span<const Index> samples,
                    const RotationAxis& start, std::span<const double> angles, Matching matching) {
  RotationAxis axis = start;
  descend(matching, [&](double scale) {
    const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(axis.direction);
    Equations<4> equations;
    for (const double angle : angles) {
      const Eigen::Matrix3d rotation = axis.rotation(angle);
      for (const Index i : samples) {
        const Eigen::Vector3d p = surface.samples().position(i).cast<double>() - axis.point;
        const Eigen::Vector3d moved = rotation * p;
        const Contact contact = contact_at(surface, axis.point + moved, scale, matching);
        // Tilting the axis by ω: dx' = ω × R x − R (ω × x). Shifting it by δ: dx' = δ − R δ.
        const Eigen::Vector3d back = rotation.transpose() * contact.normal;
        Eigen::Vector4d jacobian;
        jacobian << basis.transpose() * (moved.cross(contact.normal) - p.cross(back)),
            basis.transpose() * (contact.normal - back);
        equations.add(jacobian, contact.residual, contact.weight);
      }
    }
    const Eigen::Vector4d step = equations.step();
    const Eigen::Vector3d tilt = basis * step.head<2>();
    axis.point += basis * step.tail<2>();
    axis.direction = (axis.direction + tilt.cross(axis.direction)).normalized();
    return step.norm();
  });
  return axis;
}

}  // namespace symscene
