#include "symscene/reconstruction/camera_tracking.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "symscene/core/dispatch.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/parallel.hpp"

namespace symscene {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t lanes = 16;
constexpr std::size_t products = 27;  ///< upper half of JᵀJ, then Jᵀr
constexpr std::size_t rows_a_task = 8;

/// Matches waiting to be summed, lane by lane. A lane without a match has weight 0.
struct Batch {
  float j[6][lanes];  ///< p × n and n
  float r[lanes];     ///< n · (q − p)
  float weight[lanes];
};

/// The normal equations of a part of the image.
struct Sums {
  float product[products][lanes] = {};
  double normal[products] = {};
  double matches = 0, inliers = 0, squares = 0, weight = 0;

  void fold() {
    for (std::size_t k = 0; k < products; ++k) {
      for (float& lane : product[k]) {
        normal[k] += lane;
        lane = 0.0F;
      }
    }
  }
};

Sums combined(Sums a, const Sums& b) {
  for (std::size_t k = 0; k < products; ++k) a.normal[k] += b.normal[k];
  a.matches += b.matches;
  a.inliers += b.inliers;
  a.squares += b.squares;
  a.weight += b.weight;
  return a;
}

SYMSCENE_MULTIVERSION
void add_batch(const Batch& batch, float (*product)[lanes]) {
  std::size_t k = 0;
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = a; b < 6; ++b, ++k) {
      for (std::size_t l = 0; l < lanes; ++l) {
        product[k][l] += batch.weight[l] * batch.j[a][l] * batch.j[b][l];
      }
    }
  }
  for (std::size_t a = 0; a < 6; ++a, ++k) {
    for (std::size_t l = 0; l < lanes; ++l) {
      product[k][l] += batch.weight[l] * batch.j[a][l] * batch.r[l];
    }
  }
}

/// What decides about a match on one level.
struct Gates {
  float squared_distance;
  float cosine;
  float noise;          ///< deviation of a depth over its square [1/m]
  float floor;          ///< deviation that the model itself has [m]
  float robust_sigmas;  ///< of Cauchy's function
};

/// Matches the pixels of a measured image with those of the model's view.
class Matcher {
 public:
  Matcher(const SurfaceImage& measured, const SurfaceImage& model, const Gates& gates)
      : measured_(measured), model_(model), gates_(gates) {
    for (Index u = 0; u < measured.camera.width; ++u) {
      ray_x_.push_back(static_cast<float>(measured.camera.ray(u, 0.0).x()));
    }
    for (Index v = 0; v < measured.camera.height; ++v) {
      ray_y_.push_back(static_cast<float>(measured.camera.ray(0.0, v).y()));
    }
    for (Index u = 0; u < model.camera.width; ++u) {
      model_x_.push_back(static_cast<float>(model.camera.ray(u, 0.0).x()));
    }
    for (Index v = 0; v < model.camera.height; ++v) {
      model_y_.push_back(static_cast<float>(model.camera.ray(0.0, v).y()));
    }
  }

  Sums match(const Eigen::Isometry3d& T_model_measured) const {
    const Eigen::Isometry3f T = T_model_measured.cast<float>();
    return reduce_blocks(
        measured_.camera.height, rows_a_task, Sums{},
        [&](std::size_t begin, std::size_t end) {
          Sums sums;
          for (std::size_t v = begin; v < end; ++v) match_row(v, T, sums);
          sums.fold();
          return sums;
        },
        combined);
  }

 private:
  void match_row(std::size_t v, const Eigen::Isometry3f& T, Sums& sums) const {
    const SurfacePixel* row = measured_.pixels.data() + v * measured_.camera.width;
    Batch batch;
    std::size_t lane = 0;
    for (std::size_t u = 0; u < measured_.camera.width; ++u) {
      if (!add_match(row[u], ray_x_[u], ray_y_[v], T, batch, lane, sums)) continue;
      if (++lane < lanes) continue;
      add_batch(batch, sums.product);
      lane = 0;
    }
    if (lane == 0) return;
    for (; lane < lanes; ++lane) {
      for (auto& j : batch.j) j[lane] = 0.0F;
      batch.r[lane] = batch.weight[lane] = 0.0F;
    }
    add_batch(batch, sums.product);
  }

  bool add_match(const SurfacePixel& pixel, float ray_x, float ray_y, const Eigen::Isometry3f& T,
                 Batch& batch, std::size_t lane, Sums& sums) const {
    if (!(pixel.nz < 0.0F)) return false;
    const Eigen::Vector3f p =
        T * Eigen::Vector3f(ray_x * pixel.depth, ray_y * pixel.depth, pixel.depth);
    if (!(p.z() > 0.05F)) return false;
    const auto& camera = model_.camera;
    const float inverse = 1.0F / p.z();
    const float x = p.x() * inverse * static_cast<float>(camera.fx) + static_cast<float>(camera.cx);
    const float y = p.y() * inverse * static_cast<float>(camera.fy) + static_cast<float>(camera.cy);
    if (!(x > -0.5F && y > -0.5F && x < static_cast<float>(camera.width) - 0.5F &&
          y < static_cast<float>(camera.height) - 0.5F)) {
      return false;
    }
    const auto column = static_cast<std::size_t>(x + 0.5F);
    const auto line = static_cast<std::size_t>(y + 0.5F);
    const SurfacePixel& other = model_.pixels[line * camera.width + column];
    const Eigen::Vector3f n(other.nx, other.ny, other.nz);
    if (n.z() == 0.0F && n.x() == 0.0F && n.y() == 0.0F) return false;
    const Eigen::Vector3f q(model_x_[column] * other.depth, model_y_[line] * other.depth,
                            other.depth);
    const Eigen::Vector3f gap = q - p;
    const Eigen::Vector3f m = T.linear() * Eigen::Vector3f(pixel.nx, pixel.ny, pixel.nz);
    if (gap.squaredNorm() > gates_.squared_distance || m.dot(n) < gates_.cosine) return false;
    const float r = n.dot(gap);
    const float deviation = gates_.floor + gates_.noise * pixel.depth * pixel.depth;
    const float ratio = r / (gates_.robust_sigmas * deviation);
    const float robust = 1.0F / (1.0F + ratio * ratio);
    // Relative to the deviation at 1 m, so that weights stay about 1.
    const float scale = (gates_.floor + gates_.noise) / deviation;
    const Eigen::Vector3f turn = p.cross(n);
    for (std::size_t a = 0; a < 3; ++a) {
      batch.j[a][lane] = turn[static_cast<Eigen::Index>(a)];
      batch.j[a + 3][lane] = n[static_cast<Eigen::Index>(a)];
    }
    batch.r[lane] = r;
    batch.weight[lane] = robust * scale * scale;
    sums.matches += 1.0;
    sums.weight += static_cast<double>(batch.weight[lane]);
    if (std::abs(r) < 3.0F * deviation) {
      sums.inliers += 1.0;
      sums.squares += static_cast<double>(r) * static_cast<double>(r);
    }
    return true;
  }

  const SurfaceImage& measured_;
  const SurfaceImage& model_;
  Gates gates_;
  std::vector<float> ray_x_, ray_y_, model_x_, model_y_;
};

/// A small motion: of rotation vector ω and translation t.
Eigen::Isometry3d motion(const Vector6d& twist) {
  const Eigen::Vector3d omega = twist.head<3>();
  const double angle = omega.norm();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  if (angle > 0.0) T.linear() = Eigen::AngleAxisd(angle, omega / angle).toRotationMatrix();
  T.translation() = twist.tail<3>();
  return T;
}

/// The pose without what rounding has done to its rotation, which else grows from frame to frame.
Eigen::Isometry3d orthonormal(Eigen::Isometry3d T) {
  T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  return T;
}

/// The normal equations with rotations about the centre of what is seen and scaled by its size, so
/// that all six motions compare: eigenvalues of H over the sum of the weights lie in [0, 1].
struct Conditioned {
  Matrix6d directions;  ///< eigenvectors, in the conditioned motions
  Vector6d constraint;  ///< eigenvalues over the sum of the weights, ascending
  Vector6d along;       ///< Jᵀr along them
  Matrix6d to_twist;    ///< from conditioned motions to twists
  double weight = 0.0;
};

Conditioned condition(const Sums& sums, double range) {
  Matrix6d H;
  Vector6d g;
  std::size_t k = 0;
  for (int a = 0; a < 6; ++a) {
    for (int b = a; b < 6; ++b, ++k) H(a, b) = H(b, a) = sums.normal[k];
  }
  for (int a = 0; a < 6; ++a, ++k) g[a] = sums.normal[k];
  // A turn ω about c = (0, 0, range) moves c not at all: t = −ω × c.
  const double radius = 0.3 * range;
  Conditioned result;
  result.to_twist = Matrix6d::Identity();
  const Eigen::Vector3d c(0, 0, range);
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector3d omega = Eigen::Vector3d::Unit(a) / radius;
    result.to_twist.col(a).head<3>() = omega;
    result.to_twist.col(a).tail<3>() = -omega.cross(c);
  }
  const Matrix6d conditioned = result.to_twist.transpose() * H * result.to_twist;
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(conditioned);
  result.directions = solver.eigenvectors();
  result.constraint = solver.eigenvalues() / sums.weight;
  result.along = result.directions.transpose() * (result.to_twist.transpose() * g);
  result.weight = sums.weight;
  return result;
}

/// The step along the motions that are constrained.
Vector6d solve(const Conditioned& system, double degenerate_ratio) {
  Vector6d step = Vector6d::Zero();
  for (int k = 0; k < 6; ++k) {
    if (system.constraint[k] < degenerate_ratio) continue;
    step += system.along[k] / (system.constraint[k] * system.weight) * system.directions.col(k);
  }
  return system.to_twist * step;
}

std::vector<std::string> unconstrained_motions(const Conditioned& system, double ratio) {
  constexpr const char* names[6] = {"rotation about x",    "rotation about y",
                                    "rotation about z",    "translation along x",
                                    "translation along y", "translation along z"};
  std::vector<std::string> motions;
  for (int k = 0; k < 6; ++k) {
    if (system.constraint[k] >= ratio) continue;
    std::string motion;
    for (int a = 0; a < 6; ++a) {
      if (std::abs(system.directions(a, k)) < 0.4) continue;
      motion += (motion.empty() ? "" : " with ") + std::string(names[a]);
    }
    motions.push_back(motion);
  }
  return motions;
}

/// The view's images at the sizes of the measurement's pyramid: every second pixel.
std::vector<SurfaceImage> view_pyramid(const SurfaceImage& view, const Measurement& measurement) {
  std::vector<SurfaceImage> levels{view};
  while (levels.size() < measurement.pyramid.size()) {
    const SurfaceImage& fine = levels.back();
    SurfaceImage coarse;
    // The kept pixel is the upper left of four.
    coarse.camera = {fine.camera.width / 2, fine.camera.height / 2, 0.5 * fine.camera.fx,
                     0.5 * fine.camera.fy,  0.5 * fine.camera.cx,   0.5 * fine.camera.cy};
    coarse.pixels.resize(coarse.camera.pixels());
    for (Index v = 0; v < coarse.camera.height; ++v) {
      for (Index u = 0; u < coarse.camera.width; ++u) {
        coarse.pixels[std::size_t{v} * coarse.camera.width + u] =
            fine.pixels[std::size_t{2 * v} * fine.camera.width + std::size_t{2 * u}];
      }
    }
    levels.push_back(std::move(coarse));
  }
  return levels;
}

double mean_depth(const SurfaceImage& image) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const SurfacePixel& pixel : image.pixels) {
    if (!(pixel.nz < 0.0F)) continue;
    sum += static_cast<double>(pixel.depth);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 1.0;
}

TrackingResult lost(const Eigen::Isometry3d& guess, const char* reason) {
  TrackingResult result;
  result.T_world_camera = guess;
  result.reason = reason;
  return result;
}

}  // namespace

const char* to_string(TrackingStatus status) {
  switch (status) {
    case TrackingStatus::converged:
      return "converged";
    case TrackingStatus::degenerate:
      return "degenerate";
    case TrackingStatus::lost:
      return "lost";
  }
  return "";
}

void TrackingOptions::validate() const {
  const auto share = [](double value, const char* name) {
    require_option(value >= 0 && value <= 1, name, "a share in [0, 1]", value);
  };
  require_option(iterations_coarse >= 0 && iterations_coarse <= 100, "iterations_coarse",
                 "0 to 100", iterations_coarse);
  require_option(iterations_middle >= 0 && iterations_middle <= 100, "iterations_middle",
                 "0 to 100", iterations_middle);
  require_option(iterations_fine >= 1 && iterations_fine <= 100, "iterations_fine", "1 to 100",
                 iterations_fine);
  require_option(max_distance > 0, "max_distance", "a positive number", max_distance);
  require_option(max_angle > 0 && max_angle < 1.5, "max_angle", "a positive angle below 1.5",
                 max_angle);
  require_option(robust_sigmas > 0, "robust_sigmas", "a positive number", robust_sigmas);
  share(min_overlap, "min_overlap");
  share(min_inliers, "min_inliers");
  share(min_measured, "min_measured");
  share(degenerate_ratio, "degenerate_ratio");
  require_option(max_translation > 0, "max_translation", "a positive number", max_translation);
  require_option(max_rotation > 0, "max_rotation", "a positive angle", max_rotation);
  share(relocalize_overlap, "relocalize_overlap");
  share(relocalize_inliers, "relocalize_inliers");
  require_option(keyframe_distance > 0, "keyframe_distance", "a positive number",
                 keyframe_distance);
  require_option(keyframe_angle > 0, "keyframe_angle", "a positive angle", keyframe_angle);
}

TrackingResult track_camera(const Measurement& measurement, const ModelView& view,
                            const Eigen::Isometry3d& T_world_guess, const TrackingOptions& options,
                            const MeasurementOptions& sensor) {
  const double pixels = static_cast<double>(measurement.pyramid.front().pixels.size());
  if (static_cast<double>(measurement.measured) < options.min_measured * pixels) {
    TrackingResult result = lost(T_world_guess, "too little of the image is measured");
    result.searchable = false;
    return result;
  }
  const std::vector<SurfaceImage> models = view_pyramid(view.image, measurement);
  const int iterations[3] = {options.iterations_fine, options.iterations_middle,
                             options.iterations_coarse};
  const double range = mean_depth(measurement.pyramid.back());
  Eigen::Isometry3d T = view.T_world_camera.inverse() * T_world_guess;  // T_model_measured
  Sums sums;
  Conditioned system;
  for (std::size_t level = measurement.pyramid.size(); level-- > 0;) {
    const double distance = options.max_distance * std::pow(0.5, 2.0 - static_cast<double>(level));
    const Matcher matcher(
        measurement.pyramid[level], models[level],
        {static_cast<float>(distance * distance), static_cast<float>(std::cos(options.max_angle)),
         static_cast<float>(sensor.noise), 5e-4F, static_cast<float>(options.robust_sigmas)});
    for (int k = 0; k < iterations[level]; ++k) {
      sums = matcher.match(T);
      if (sums.matches < 50.0) return lost(T_world_guess, "the model is not in view");
      system = condition(sums, range);
      const Vector6d step = solve(system, options.degenerate_ratio);
      if (!step.allFinite()) return lost(T_world_guess, "the alignment diverged");
      T = motion(step) * T;
      if (level > 0 && step.head<3>().norm() < 1e-4 && step.tail<3>().norm() < 1e-4) break;
    }
  }
  TrackingResult result;
  result.T_world_camera = orthonormal(view.T_world_camera * T);
  result.overlap = sums.matches / static_cast<double>(measurement.measured);
  result.inliers = sums.inliers / sums.matches;
  result.residual = std::sqrt(sums.squares / std::max(sums.inliers, 1.0));
  result.unconstrained = unconstrained_motions(system, options.degenerate_ratio);
  if (result.overlap < options.min_overlap) {
    result.reason = "too little of the image agrees with the model";
  } else if (result.inliers < options.min_inliers) {
    result.reason = "the image does not fit the model";
  } else if (T.translation().norm() > options.max_translation ||
             Eigen::AngleAxisd(T.linear()).angle() > options.max_rotation) {
    result.reason = "the camera would have jumped";
  } else {
    result.status =
        result.unconstrained.empty() ? TrackingStatus::converged : TrackingStatus::degenerate;
  }
  return result;
}

}  // namespace symscene
