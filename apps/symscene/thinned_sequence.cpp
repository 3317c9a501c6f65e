#include "thinned_sequence.hpp"

#include <utility>

namespace symscene::app {
namespace {

class ThinnedSequence final : public DepthSequence {
 public:
  ThinnedSequence(std::unique_ptr<DepthSequence> whole, std::size_t step)
      : whole_(std::move(whole)), step_(step) {}

  std::string layout() const override { return whole_->layout(); }
  const CameraIntrinsics& camera() const override { return whole_->camera(); }
  double depth_scale() const override { return whole_->depth_scale(); }
  std::size_t size() const override { return (whole_->size() + step_ - 1) / step_; }
  double time(std::size_t i) const override { return whole_->time(i * step_); }
  bool has_color(std::size_t i) const override { return whole_->has_color(i * step_); }
  bool has_color() const override {
    for (std::size_t i = 0; i < size(); ++i) {
      if (has_color(i)) return true;
    }
    return false;
  }
  std::optional<Eigen::Isometry3d> pose(std::size_t i) const override {
    return whole_->pose(i * step_);
  }
  const std::vector<std::string>& warnings() const override { return whole_->warnings(); }
  DepthFrame read(std::size_t i) const override { return whole_->read(i * step_); }

 private:
  std::unique_ptr<DepthSequence> whole_;
  std::size_t step_;
};

}  // namespace

std::unique_ptr<DepthSequence> every_nth(std::unique_ptr<DepthSequence> sequence,
                                         std::size_t step) {
  if (step == 1) return sequence;
  return std::make_unique<ThinnedSequence>(std::move(sequence), step);
}

}  // namespace symscene::app
