#include "symscene/reconstruction/camera_tracking.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"
#include "core/twist.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::size_t lanes = 64;
constexpr std::size_t products = 27;  ///< upper half of JᵀJ, then Jᵀr
constexpr std::size_t rows_a_task = 8;
constexpr double least_matches = 50.0;
constexpr float model_deviation = 5e-4F;  // of a depth that the model shows [m]

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
  double shown = 0;  ///< measured pixels where the model shows something
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
  a.shown += b.shown;
  a.matches += b.matches;
  a.inliers += b.inliers;
  a.squares += b.squares;
  a.weight += b.weight;
  return a;
}

SYMSCENE_MULTIVERSION
void add_batch(const Batch& batch, float (*__restrict product)[lanes]) {
  std::size_t k = 0;
  for (std::size_t a = 0; a < 6; ++a) {
    float weighted[lanes];
    for (std::size_t l = 0; l < lanes; ++l) weighted[l] = batch.weight[l] * batch.j[a][l];
    for (std::size_t b = a; b < 6; ++b, ++k) {
      for (std::size_t l = 0; l < lanes; ++l) product[k][l] += weighted[l] * batch.j[b][l];
    }
    float* const side = product[products - 6 + a];
    for (std::size_t l = 0; l < lanes; ++l) side[l] += weighted[l] * batch.r[l];
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

  /// What the matches ask of the motion, from the model's normals n.
  Sums match(const Eigen::Isometry3d& T_model_measured) const {
    return sum_rows<false>(T_model_measured.cast<float>());
  }

  /// What they constrain: as match(), but with n mᵀ in place of n nᵀ, m being the measured normals.
  /// The noise of both is independent, so that it does not add up to constraints that are not
  /// there.
  Sums match_constraints(const Eigen::Isometry3d& T_model_measured) const {
    return sum_rows<true>(T_model_measured.cast<float>());
  }

 private:
  template <bool constraints>
  Sums sum_rows(const Eigen::Isometry3f& T) const {
    return reduce_blocks(
        measured_.camera.height, rows_a_task, Sums{},
        [&](std::size_t begin, std::size_t end) {
          Sums sums;
          for (std::size_t v = begin; v < end; ++v) match_row<constraints>(v, T, sums);
          sums.fold();
          return sums;
        },
        combined);
  }

  template <bool constraints>
  void match_row(std::size_t v, const Eigen::Isometry3f& T, Sums& sums) const {
    const SurfacePixel* row = measured_.pixels.data() + v * measured_.camera.width;
    Batch batch;
    std::size_t lane = 0;
    for (std::size_t u = 0; u < measured_.camera.width; ++u) {
      if (!add_match<constraints>(row[u], ray_x_[u], ray_y_[v], T, batch, lane, sums)) continue;
      if (lane < lanes) continue;
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

  template <bool constraints>
  bool add_match(const SurfacePixel& pixel, float ray_x, float ray_y, const Eigen::Isometry3f& T,
                 Batch& batch, std::size_t& lane, Sums& sums) const {
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
    sums.shown += 1.0;
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
    const float weight = robust * scale * scale;
    if constexpr (constraints) {
      // ½ (n mᵀ + m nᵀ) = ¼ (n + m)(n + m)ᵀ − ¼ (n − m)(n − m)ᵀ
      add_lane(p, 0.5F * (n + m), 0.0F, weight, batch, lane);
      add_lane(p, 0.5F * (n - m), 0.0F, -weight, batch, lane);
    } else {
      add_lane(p, n, r, weight, batch, lane);
    }
    sums.matches += 1.0;
    sums.weight += static_cast<double>(weight);
    if (std::abs(r) < 3.0F * deviation) {
      sums.inliers += 1.0;
      sums.squares += static_cast<double>(r) * static_cast<double>(r);
    }
    return true;
  }

  static void add_lane(const Eigen::Vector3f& p, const Eigen::Vector3f& n, float r, float weight,
                       Batch& batch, std::size_t& lane) {
    const Eigen::Vector3f turn = p.cross(n);
    for (std::size_t a = 0; a < 3; ++a) {
      batch.j[a][lane] = turn[static_cast<Eigen::Index>(a)];
      batch.j[a + 3][lane] = n[static_cast<Eigen::Index>(a)];
    }
    batch.r[lane] = r;
    batch.weight[lane] = weight;
    ++lane;
  }

  const SurfaceImage& measured_;
  const SurfaceImage& model_;
  Gates gates_;
  std::vector<float> ray_x_, ray_y_, model_x_, model_y_;
};

/// From motions that compare with each other to twists: rotations are about the centre of what is
/// seen, at (0, 0, range), and measured by how far they move points about it.
Matrix6d comparable_motions(double range) {
  const double radius = 0.3 * range;
  const Eigen::Vector3d center(0, 0, range);
  Matrix6d to_twist = Matrix6d::Identity();
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector3d omega = Eigen::Vector3d::Unit(a) / radius;
    to_twist.col(a).head<3>() = omega;
    to_twist.col(a).tail<3>() = -omega.cross(center);
  }
  return to_twist;
}

Matrix6d normal_matrix(const Sums& sums) {
  Matrix6d H;
  std::size_t k = 0;
  for (int a = 0; a < 6; ++a) {
    for (int b = a; b < 6; ++b, ++k) H(a, b) = H(b, a) = sums.normal[k];
  }
  return H;
}

Vector6d right_side(const Sums& sums) {
  return Eigen::Map<const Vector6d>(sums.normal + products - 6);
}

/// The motions that the surface constrains, and how much: all of them together by 1.
struct Constraints {
  Matrix6d motions;  ///< orthonormal columns, comparable motions, the freest first
  Vector6d amounts;  ///< ascending
  int free = 0;      ///< how many of them are not constrained
};

Constraints find_constraints(const Sums& sums, const Matrix6d& to_twist, double least) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(to_twist.transpose() * normal_matrix(sums) *
                                                       to_twist / sums.weight);
  Constraints found{solver.eigenvectors(), solver.eigenvalues(), 0};
  found.free = static_cast<int>((found.amounts.array() < least).count());
  return found;
}

/// The step along the motions that are constrained.
Vector6d solve(const Sums& sums, const Matrix6d& to_twist, const Constraints& constraints) {
  if (constraints.free == 6) return Vector6d::Zero();
  const Eigen::MatrixXd basis = to_twist * constraints.motions.rightCols(6 - constraints.free);
  return basis * (basis.transpose() * normal_matrix(sums) * basis)
                     .ldlt()
                     .solve(basis.transpose() * right_side(sums));
}

/// The free motions as near to those along and about the camera's axes as they can be named.
std::vector<std::string> names_of_free_motions(const Constraints& constraints) {
  constexpr const char* names[6] = {"rotation about x",    "rotation about y",
                                    "rotation about z",    "translation along x",
                                    "translation along y", "translation along z"};
  Matrix6d left = constraints.motions.leftCols(constraints.free) *
                  constraints.motions.leftCols(constraints.free).transpose();
  std::vector<std::string> motions;
  for (int k = 0; k < constraints.free; ++k) {
    int nearest = 0;
    const double length = std::sqrt(left.diagonal().maxCoeff(&nearest));
    const Vector6d direction = left.col(nearest) / length;
    left -= direction * direction.transpose();
    std::string motion;
    for (int a = 0; a < 6; ++a) {
      if (std::abs(direction[a]) < 0.4) continue;
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
  const auto positive = [](double value, const char* name) {
    require_option(value > 0 && value <= 1e6, name, "a positive number up to a million", value);
  };
  require_option(iterations_coarse >= 0 && iterations_coarse <= 100, "iterations_coarse",
                 "0 to 100", iterations_coarse);
  require_option(iterations_middle >= 0 && iterations_middle <= 100, "iterations_middle",
                 "0 to 100", iterations_middle);
  require_option(iterations_fine >= 1 && iterations_fine <= 100, "iterations_fine", "1 to 100",
                 iterations_fine);
  positive(max_distance, "max_distance");
  require_option(max_angle > 0 && max_angle < 1.5, "max_angle", "a positive angle below 1.5",
                 max_angle);
  positive(robust_sigmas, "robust_sigmas");
  share(min_overlap, "min_overlap");
  share(min_inliers, "min_inliers");
  share(min_measured, "min_measured");
  share(degenerate_ratio, "degenerate_ratio");
  positive(max_translation, "max_translation");
  positive(max_rotation, "max_rotation");
  share(relocalize_overlap, "relocalize_overlap");
  share(relocalize_inliers, "relocalize_inliers");
  share(max_disagreement, "max_disagreement");
  positive(keyframe_distance, "keyframe_distance");
  positive(keyframe_angle, "keyframe_angle");
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
  const Matrix6d to_twist = comparable_motions(range);
  Constraints constraints;
  for (std::size_t level = measurement.pyramid.size(); level-- > 0;) {
    const double distance = options.max_distance * std::pow(0.5, 2.0 - static_cast<double>(level));
    const Matcher matcher(
        measurement.pyramid[level], models[level],
        {static_cast<float>(distance * distance), static_cast<float>(std::cos(options.max_angle)),
         static_cast<float>(sensor.noise), model_deviation,
         static_cast<float>(options.robust_sigmas)});
    if (iterations[level] == 0) continue;
    const Sums constraining = matcher.match_constraints(T);
    if (constraining.matches < least_matches)
      return lost(T_world_guess, "the model is not in view");
    constraints = find_constraints(constraining, to_twist, options.degenerate_ratio);
    for (int k = 0; k < iterations[level]; ++k) {
      sums = matcher.match(T);
      if (sums.matches < least_matches) return lost(T_world_guess, "the model is not in view");
      const Vector6d step = solve(sums, to_twist, constraints);
      if (!step.allFinite()) return lost(T_world_guess, "the alignment diverged");
      T = motion(step) * T;
      if (level > 0 && step.head<3>().norm() < 1e-4 && step.tail<3>().norm() < 1e-4) break;
    }
  }
  TrackingResult result;
  result.T_world_camera = orthonormal(view.T_world_camera * T);
  result.overlap = sums.matches / static_cast<double>(measurement.measured);
  result.inliers = sums.inliers / sums.matches;
  result.agreement = sums.inliers / sums.shown;
  result.residual = std::sqrt(sums.squares / std::max(sums.inliers, 1.0));
  result.unconstrained = names_of_free_motions(constraints);
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

std::vector<Eigen::Isometry3d> likely_poses(const Measurement& measurement, const ModelView& view,
                                            const Eigen::Isometry3d& T_world_about,
                                            std::size_t count, const TrackingOptions& options,
                                            const MeasurementOptions& sensor) {
  constexpr int reach = 5;        // steps of the grid to each side
  constexpr double step = 0.05;   // [m], rotations by how far they move points about the centre
  constexpr float near = 0.025F;  // between points that agree [m]
  const std::vector<SurfaceImage> models = view_pyramid(view.image, measurement);
  const Matcher matcher(measurement.pyramid.back(), models.back(),
                        {near * near, static_cast<float>(std::cos(options.max_angle)),
                         static_cast<float>(sensor.noise), model_deviation,
                         static_cast<float>(options.robust_sigmas)});
  const Eigen::Isometry3d T_about = view.T_world_camera.inverse() * T_world_about;
  const Matrix6d to_twist = comparable_motions(mean_depth(measurement.pyramid.back()));
  const Sums here = matcher.match_constraints(T_about);
  if (here.matches < least_matches) return {};
  const Constraints constraints = find_constraints(here, to_twist, options.degenerate_ratio);
  std::vector<std::pair<double, Eigen::Isometry3d>> tried;
  for (int a = -reach; a <= reach; ++a) {
    for (int b = -reach; b <= reach; ++b) {
      for (int c = -reach; c <= reach; ++c) {
        const Vector6d offset =
            constraints.motions.leftCols<3>() * (step * Eigen::Vector3d(a, b, c));
        const Eigen::Isometry3d T = motion(to_twist * offset) * T_about;
        tried.emplace_back(-matcher.match(T).inliers, view.T_world_camera * T);
      }
    }
  }
  std::stable_sort(tried.begin(), tried.end(),
                   [](const auto& x, const auto& y) { return x.first < y.first; });
  std::vector<Eigen::Isometry3d> poses{T_world_about};
  for (std::size_t k = 0; k < std::min(count - 1, tried.size()); ++k) {
    poses.push_back(orthonormal(tried[k].second));
  }
  return poses;
}

}  // namespace symscene
