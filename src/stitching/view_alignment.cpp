#include "view_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"
#include "view_matching.hpp"

namespace symscene {
namespace {

/// Two different views. The pixels of `moved` are matched with those of `fixed`.
struct ViewPair {
  std::size_t moved = 0;
  std::size_t fixed = 0;
  PairSystem system = {};
};

std::vector<ViewPair> all_pairs(std::size_t views) {
  std::vector<ViewPair> pairs;
  for (std::size_t i = 0; i < views; ++i) {
    for (std::size_t j = 0; j < views; ++j) {
      if (i != j) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// The normal equations of all poses but the first (Gauss-Newton).
class JointSystem {
 public:
  explicit JointSystem(std::size_t views)
      : H_(Eigen::MatrixXd::Zero(6 * static_cast<Eigen::Index>(views),
                                 6 * static_cast<Eigen::Index>(views))),
        g_(Eigen::VectorXd::Zero(H_.rows())) {}

  void add(std::size_t moved, std::size_t fixed, const PairSystem& pair) {
    const auto m = 6 * static_cast<Eigen::Index>(moved);
    const auto f = 6 * static_cast<Eigen::Index>(fixed);
    H_.block<6, 6>(m, m) += pair.A;
    H_.block<6, 6>(f, f) += pair.A;
    H_.block<6, 6>(m, f) -= pair.A;
    H_.block<6, 6>(f, m) -= pair.A;
    g_.segment<6>(m) += pair.b;
    g_.segment<6>(f) -= pair.b;
  }

  /// One twist per view. Unconstrained motions are zero.
  Eigen::VectorXd solve() const {
    constexpr double damping = 1e-9;
    const Eigen::Index free = H_.rows() - 6;
    Eigen::MatrixXd H = H_.bottomRightCorner(free, free);
    H.diagonal().array() += std::max(damping * H.trace(), 1e-12);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(H_.rows());
    step.tail(free) = H.ldlt().solve(-g_.tail(free));
    return step;
  }

 private:
  Eigen::MatrixXd H_;
  Eigen::VectorXd g_;
};

class Aligner {
 public:
  Aligner(std::span<const Measurement> views, std::span<const Eigen::Isometry3d> poses,
          std::span<const PointPairs> points, const ViewAlignmentOptions& options,
          const MeasurementOptions& sensor)
      : views_(views),
        points_(points),
        options_(options),
        sensor_(sensor),
        poses_(poses.begin(), poses.end()),
        pairs_(all_pairs(views.size())) {}

  ViewAlignment run() {
    const std::size_t levels = views_.front().pyramid.size();
    repeat(options_.iterations_points, [this] { return step(false, 0); });
    const int iterations[3] = {options_.iterations_fine, options_.iterations_middle,
                               options_.iterations_coarse};
    for (std::size_t level = levels; level-- > 0;) {
      repeat(iterations[level], [&] { return step(true, level); });
      if (level + 1 == levels) keep_overlapping(level);
    }
    match(0);
    return {poses_, fits(), iterations_, last_step_ < options_.convergence};
  }

 private:
  template <class Step>
  void repeat(int count, const Step& step) {
    for (int k = 0; k < count && step(); ++k) ++iterations_;
  }

  const SurfaceImage& image(std::size_t view, std::size_t level) const {
    return views_[view].pyramid[level];
  }

  void match(std::size_t level) {
    const auto noise = static_cast<float>(sensor_.noise);
    const MatchOptions matching{
        .max_distance = options_.max_distance * std::pow(0.5, 2.0 - static_cast<double>(level)),
        .max_angle = options_.max_angle,
        .robust_sigmas = options_.robust_sigmas,
        .noise = {.floor = static_cast<float>(options_.surface_deviation),
                  .moved = noise,
                  .fixed = noise}};
    parallel_for_each(pairs_.size(), [&](std::size_t k) {
      ViewPair& pair = pairs_[k];
      pair.system = match_surfaces({image(pair.moved, level), poses_[pair.moved]},
                                   {image(pair.fixed, level), poses_[pair.fixed]}, matching);
    });
  }

  /// One step of all poses. Returns whether they moved much.
  bool step(bool surfaces, std::size_t level) {
    JointSystem joint(views_.size());
    for (const PointPairs& pair : points_) {
      joint.add(pair.first, pair.second,
                match_points(pair, poses_[pair.first], poses_[pair.second], options_));
    }
    if (surfaces) {
      match(level);
      for (const ViewPair& pair : pairs_) joint.add(pair.moved, pair.fixed, pair.system);
    }
    const Eigen::VectorXd twists = joint.solve();
    if (!twists.allFinite()) {
      last_step_ = std::numeric_limits<double>::infinity();
      return false;
    }
    for (std::size_t i = 1; i < poses_.size(); ++i) {
      const Vector6d twist = twists.segment<6>(6 * static_cast<Eigen::Index>(i));
      poses_[i] = orthonormal(motion(twist) * poses_[i]);
    }
    last_step_ = twists.cwiseAbs().maxCoeff();
    return last_step_ >= options_.convergence;
  }

  /// Drops the pairs with too little surface in common to be worth their time.
  void keep_overlapping(std::size_t level) {
    match(level);
    std::erase_if(pairs_, [&](const ViewPair& pair) {
      const auto pixels = static_cast<double>(image(pair.moved, level).pixels.size());
      return pair.system.fit.matches < options_.min_overlap * pixels;
    });
  }

  std::vector<ViewFit> fits() const {
    std::vector<PoseFit> sums(views_.size());
    for (const ViewPair& pair : pairs_) {
      for (const std::size_t view : {pair.moved, pair.fixed}) sums[view] += pair.system.fit;
    }
    std::vector<ViewFit> fits;
    for (const PoseFit& sum : sums) {
      fits.push_back({static_cast<std::size_t>(sum.matches), sum.inlier_share(), sum.residual()});
    }
    return fits;
  }

  std::span<const Measurement> views_;
  std::span<const PointPairs> points_;
  const ViewAlignmentOptions& options_;
  const MeasurementOptions& sensor_;
  std::vector<Eigen::Isometry3d> poses_;
  std::vector<ViewPair> pairs_;
  int iterations_ = 0;
  double last_step_ = 0.0;
};

void require_views(std::span<const Measurement> views, std::size_t poses,
                   std::span<const PointPairs> pairs) {
  if (views.size() != poses) {
    throw InputError("views", std::to_string(views.size()) + " poses", std::to_string(poses));
  }
  for (const PointPairs& pair : pairs) {
    if (pair.first < views.size() && pair.second < views.size() && pair.first != pair.second &&
        pair.points_first.cols() == pair.points_second.cols()) {
      continue;
    }
    throw InputError("pairs of points", "as many points of one view as of another",
                     "views " + std::to_string(pair.first) + " and " + std::to_string(pair.second));
  }
}

}  // namespace

ViewAlignment align_views(std::span<const Measurement> views,
                          std::span<const Eigen::Isometry3d> T_world_camera,
                          std::span<const PointPairs> pairs, const ViewAlignmentOptions& options,
                          const MeasurementOptions& sensor) {
  options.validate();
  require_views(views, T_world_camera.size(), pairs);
  if (views.size() < 2) {
    return {{T_world_camera.begin(), T_world_camera.end()},
            std::vector<ViewFit>(views.size()),
            0,
            true};
  }
  return Aligner(views, T_world_camera, pairs, options, sensor).run();
}

}  // namespace symscene
