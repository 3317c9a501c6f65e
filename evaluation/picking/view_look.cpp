#include "view_look.hpp"

#include <limits>
#include <numeric>

#include "symscene/view_planning/next_view.hpp"

namespace symscene {
namespace {

/// One call of look_from_views().
class ViewLook {
 public:
  ViewLook(std::span<const Eigen::Isometry3d> views, const CameraTravel& travel,
           const ArmCell& cell, const SimulatedPickOptions& options, LookImages& images,
           TablePerception& perception)
      : views_(views),
        travel_(travel),
        cell_(cell),
        options_(options),
        images_(images),
        perception_(perception),
        tried_(views.size(), 0) {}

  TakenLook take() {
    TakenLook look;
    while (taken_ < options_.look.max_views) {
      const NextViews next = ranked();
      look.is_enough = next.is_enough && !next.ranked.empty();  // else no view is left
      if (next.is_enough || !go(order(next))) break;
    }
    look.robot_share = taken_ == 0 ? 0.0 : covered_ / taken_;
    return look;
  }

 private:
  /// Empty, and not enough, while nothing is known.
  NextViews ranked() {
    const PerceivedScene& known = perception_.perceived();
    if (known.result.objects.empty() || !known.scene.occupancy) return {};
    std::vector<double> costs = travel_.costs();
    for (std::size_t i = 0; i < costs.size(); ++i) {
      if (tried_[i] != 0) costs[i] = std::numeric_limits<double>::infinity();
    }
    return perception_.timer().time("next view", [&] {
      return rank_views({known.result, &*known.scene.occupancy}, options_.look.intrinsics(), views_,
                        options_.next_view, ViewPolicy::symmetry, costs);
    });
  }

  std::vector<std::size_t> order(const NextViews& next) const {
    std::vector<std::size_t> views;
    for (const RankedView& view : next.ranked) views.push_back(view.candidate);
    if (!views.empty()) return views;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      if (tried_[i] == 0) views.push_back(i);
    }
    return views;
  }

  /// Whether an image was taken from one of the views, the first that has a way.
  bool go(const std::vector<std::size_t>& order) {
    for (const std::size_t view : order) {
      tried_[view] = 1;
      const std::optional<CameraMoment> moment = travel_.to(view);
      if (!moment) continue;
      covered_ += images_.add(cell_, {&*moment, 1}, perception_);
      ++taken_;
      return true;
    }
    return false;
  }

  std::span<const Eigen::Isometry3d> views_;
  const CameraTravel& travel_;
  const ArmCell& cell_;
  const SimulatedPickOptions& options_;
  LookImages& images_;
  TablePerception& perception_;
  std::vector<std::uint8_t> tried_;
  int taken_ = 0;
  double covered_ = 0.0;
};

}  // namespace

TakenLook look_from_views(std::span<const Eigen::Isometry3d> views, const CameraTravel& travel,
                          const ArmCell& cell, const SimulatedPickOptions& options,
                          LookImages& images, TablePerception& perception) {
  return ViewLook(views, travel, cell, options, images, perception).take();
}

}  // namespace symscene
