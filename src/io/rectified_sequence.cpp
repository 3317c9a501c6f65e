#include "rectified_sequence.hpp"

#include "symscene/core/frame_rectifier.hpp"

namespace symscene {
namespace {

class RectifiedSequence final : public DepthSequence {
 public:
  RectifiedSequence(std::unique_ptr<DepthSequence> measured, const CameraModel& camera)
      : measured_(std::move(measured)), rectifier_(camera) {}

  std::string layout() const override { return measured_->layout(); }
  const CameraIntrinsics& camera() const override { return measured_->camera(); }
  double depth_scale() const override { return measured_->depth_scale(); }
  std::size_t size() const override { return measured_->size(); }
  double time(std::size_t i) const override { return measured_->time(i); }
  bool has_color() const override { return measured_->has_color(); }
  bool has_color(std::size_t i) const override { return measured_->has_color(i); }
  std::optional<Eigen::Isometry3d> pose(std::size_t i) const override { return measured_->pose(i); }
  const std::vector<std::string>& warnings() const override { return measured_->warnings(); }
  DepthFrame read(std::size_t i) const override { return rectifier_.rectified(measured_->read(i)); }

 private:
  std::unique_ptr<DepthSequence> measured_;
  FrameRectifier rectifier_;
};

}  // namespace

std::unique_ptr<DepthSequence> rectified_sequence(std::unique_ptr<DepthSequence> measured,
                                                  const CameraModel& camera) {
  return std::make_unique<RectifiedSequence>(std::move(measured), camera);
}

}  // namespace symscene
