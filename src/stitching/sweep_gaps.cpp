#include "sweep_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/median.hpp"
#include "core/parallel.hpp"
#include "pair_pose.hpp"
#include "reconstruction/camera_tracking.hpp"
#include "reconstruction/relocalization.hpp"

namespace symscene {
namespace {

/// A pose of a pair, and the share of the pixels of both frames that contradict it.
struct RatedPose {
  Eigen::Isometry3d T_first_second = Eigen::Isometry3d::Identity();
  double disagreement = std::numeric_limits<double>::infinity();
};

class SweepGaps {
 public:
  SweepGaps(std::span<const Measurement* const> frames, const StitchingOptions& options,
            TrackingOptions tracking, const PoseOfPair& from_features,
            std::vector<StitchedPair>& pairs)
      : frames_(frames),
        options_(options),
        tracking_(tracking),
        from_features_(from_features),
        pairs_(pairs) {
    tracking_.max_translation = tracking_.max_rotation = std::numeric_limits<double>::infinity();
    candidates_.resize(pairs.size());
  }

  void close() {
    if (2 * joined() < last()) return;  // what is usual is not known
    parallel_for_each(pairs_.size(), [&](std::size_t k) {
      const PairPose& pose = pairs_[k].pose;
      if (pose.status == PairStatus::accepted) refine(k, pose.T_first_second);
    });
    for (std::size_t i = 0; i < last(); ++i) {
      if (is_joined(consecutive(i).pose.status)) continue;
      search_features(i);
      search_one(i, {Eigen::Isometry3d::Identity()});
    }
    judge();
    // A pair that is joined shows the motion across the next gap.
    for (std::size_t before = 0, now = joined(); now > before && now < last();) {
      for (std::size_t i = 0; i < last(); ++i) {
        if (!is_joined(consecutive(i).pose.status)) search_one(i, motions_beside(i));
      }
      judge();
      before = now;
      now = joined();
    }
  }

 private:
  std::size_t last() const { return frames_.empty() ? 0 : frames_.size() - 1; }
  /// The place of the pair of frames i and i + 1 among the pairs (0, 1), (0, 2), ..., (1, 2), ...
  std::size_t place(std::size_t i) const { return i * (2 * frames_.size() - i - 1) / 2; }
  StitchedPair& consecutive(std::size_t i) { return pairs_[place(i)]; }
  const SurfaceImage& surface(std::size_t i) const { return frames_[i]->pyramid.front(); }

  std::size_t joined() {
    std::size_t count = 0;
    for (std::size_t i = 0; i < last(); ++i) count += is_joined(consecutive(i).pose.status) ? 1 : 0;
    return count;
  }

  /// Poses from features are too coarse to tell a right one by its depth images.
  void refine(std::size_t k, const Eigen::Isometry3d& T) {
    offer(k, T);
    const TrackingResult found = track_camera(*frames_[pairs_[k].second], view_of(pairs_[k].first),
                                              T, tracking_, options_.measurement);
    if (found.status != TrackingStatus::lost) offer(k, found.T_world_camera);
  }

  /// Few features that agree are no proof of a pose, but a start.
  void search_features(std::size_t i) {
    const std::optional<Eigen::Isometry3d> T = from_features_(i, i + 1);
    if (T) refine(place(i), *T);
  }

  void search_one(std::size_t i, const std::vector<Eigen::Isometry3d>& motions) {
    for (const Eigen::Isometry3d& motion : motions) {
      for (const auto& find : {track_camera, search_camera}) {
        const TrackingResult found =
            find(*frames_[i + 1], view_of(i), motion, tracking_, options_.measurement);
        if (found.status == TrackingStatus::converged) offer(place(i), found.T_world_camera);
      }
    }
  }

  /// The motions of the nearest joined pairs before and after a gap.
  std::vector<Eigen::Isometry3d> motions_beside(std::size_t i) {
    std::vector<Eigen::Isometry3d> motions;
    const auto add = [&](std::size_t k) {
      if (!is_joined(consecutive(k).pose.status)) return false;
      motions.push_back(consecutive(k).pose.T_first_second);
      return true;
    };
    for (std::size_t k = i; k-- > 0 && !add(k);) {
    }
    for (std::size_t k = i + 1; k < last() && !add(k); ++k) {
    }
    return motions;
  }

  ModelView view_of(std::size_t i) const { return {surface(i), Eigen::Isometry3d::Identity()}; }

  void offer(std::size_t k, const Eigen::Isometry3d& T_first_second) {
    const double contradicted = disagreement(pairs_[k], T_first_second);
    if (contradicted < candidates_[k].disagreement) candidates_[k] = {T_first_second, contradicted};
  }

  double disagreement(const StitchedPair& pair, const Eigen::Isometry3d& T_first_second) const {
    const auto sensor = static_cast<float>(options_.measurement.noise);
    const DepthNoise noise{
        .floor = static_cast<float>(tracking_.model_deviation), .moved = sensor, .fixed = sensor};
    return 1.0 - mutual_agreement(surface(pair.first), surface(pair.second), T_first_second, noise)
                     .agreement;
  }

  /// Joins the consecutive pairs that are contradicted little more than is usual among them, and
  /// parts those that are contradicted more: features on repeated patterns agree on wrong poses.
  void judge() {
    const double bound = largest_disagreement();
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      StitchedPair& pair = pairs_[k];
      if (pair.pose.status == PairStatus::accepted &&
          candidates_[k].disagreement > bound + tracking_.max_disagreement)
        pair.pose.status = PairStatus::contradicted;
    }
    for (std::size_t i = 0; i < last(); ++i) {
      const RatedPose& candidate = candidates_[place(i)];
      if (!is_joined(consecutive(i).pose.status) && candidate.disagreement <= bound)
        join(i, candidate.T_first_second);
    }
  }

  /// The level that consecutive pairs have in common is the sensor's; a wrong pose exceeds it.
  double largest_disagreement() const {
    std::vector<double> all;
    for (std::size_t i = 0; i < last(); ++i) all.push_back(candidates_[place(i)].disagreement);
    const double usual = median(all).value_or(0.0);
    for (double& value : all) value = std::abs(value - usual);
    const double spread = median(std::move(all)).value_or(0.0);
    return usual + options_.pairs.sweep_spreads * spread + options_.pairs.sweep_slack;
  }

  void join(std::size_t i, const Eigen::Isometry3d& T_first_second) {
    const DepthAgreement depth =
        mutual_agreement(surface(i), surface(i + 1), T_first_second, options_);
    if (status_of(depth, options_.pairs) != PairStatus::accepted) return;
    PairPose& pose = consecutive(i).pose;
    pose = {PairStatus::tracked, T_first_second, pose.matches, {}, depth};
  }

  std::span<const Measurement* const> frames_;
  const StitchingOptions& options_;
  TrackingOptions tracking_;
  const PoseOfPair& from_features_;
  std::vector<StitchedPair>& pairs_;
  std::vector<RatedPose> candidates_;  ///< of each pair, the one contradicted least
};

}  // namespace

void close_gaps(std::span<const Measurement* const> frames, const StitchingOptions& options,
                const TrackingOptions& tracking, const PoseOfPair& from_features,
                std::vector<StitchedPair>& pairs) {
  SweepGaps(frames, options, tracking, from_features, pairs).close();
}

}  // namespace symscene
