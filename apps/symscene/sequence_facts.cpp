#include <cmath>

#include <fmt/format.h>

#include "facts.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene::app {
namespace {

/// A histogram of depths in bins of 1 mm, for quantiles in constant memory.
class DepthHistogram {
 public:
  void add(const std::vector<float>& depth) {
    pixels_ += depth.size();
    for (const float metres : depth) {
      if (!(metres > 0.0F)) continue;
      ++measured_;
      const auto bin = static_cast<std::size_t>(std::min(std::round(metres * 1000.0F), 65535.0F));
      ++counts_[bin];
    }
  }

  std::size_t measured() const { return measured_; }
  double measured_share() const {
    return pixels_ == 0 ? 0.0 : static_cast<double>(measured_) / static_cast<double>(pixels_);
  }

  /// The quantile `share` of the measured depths. [m]
  double quantile(double share) const {
    const auto wanted = std::max(1.0, std::ceil(share * static_cast<double>(measured_)));
    std::size_t seen = 0;
    for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
      seen += counts_[bin];
      if (static_cast<double>(seen) >= wanted) return static_cast<double>(bin) / 1000.0;
    }
    return 0.0;
  }

 private:
  std::vector<std::size_t> counts_ = std::vector<std::size_t>(65536);
  std::size_t pixels_ = 0;
  std::size_t measured_ = 0;
};

/// Statistics of the frames that were read.
struct Sample {
  std::size_t frames = 0;
  std::size_t colored = 0;
  DepthHistogram depth;
  std::vector<std::string> unreadable;  ///< the error of each such frame
};

Sample read_sample(const DepthSequence& sequence, const std::vector<std::size_t>& numbers) {
  Sample sample;
  for (const std::size_t i : numbers) {
    ++sample.frames;
    try {
      const DepthFrame frame = sequence.read(i);
      sample.colored += frame.colors.rows() != 0 ? 1 : 0;
      sample.depth.add(frame.depth);
    } catch (const InputError& error) {
      sample.unreadable.emplace_back(error.what());
    }
  }
  return sample;
}

std::string of_read(std::size_t count, const Sample& sample) {
  return fmt::format("{} of the {} read", count, sample.frames);
}

void add_times(Facts& facts, const DepthSequence& sequence) {
  const std::size_t frames = sequence.size();
  const double duration = sequence.time(frames - 1) - sequence.time(0);
  const double rate = duration > 0.0 ? static_cast<double>(frames - 1) / duration : 0.0;
  std::string text = fmt::format("{}", frames);
  if (rate > 0.0) text += fmt::format(" in {:.2f} s, {:.1f} per second", duration, rate);
  facts.add("frames", text, "frames", frames);
  facts.add_member("duration", duration);
  facts.add_member("rate", rate);
}

void add_camera(Facts& facts, const CameraIntrinsics& camera) {
  facts.add("camera",
            fmt::format("{}×{}, fx {:g} fy {:g} cx {:g} cy {:g}", camera.width, camera.height,
                        camera.fx, camera.fy, camera.cx, camera.cy),
            "camera",
            {{"width", camera.width},
             {"height", camera.height},
             {"fx", camera.fx},
             {"fy", camera.fy},
             {"cx", camera.cx},
             {"cy", camera.cy}});
}

void add_depth(Facts& facts, const Sample& sample) {
  const DepthHistogram& depth = sample.depth;
  const double share = depth.measured_share();
  if (depth.measured() == 0) {
    facts.add_row("depth", "no depth measured in the frames read");
  } else {
    facts.add_row("depth",
                  fmt::format("{:.3f} to {:.3f} m, median {:.3f} m; {:.1f} % of the pixels "
                              "measured in the {} frames read",
                              depth.quantile(0.0), depth.quantile(1.0), depth.quantile(0.5),
                              100.0 * share, sample.frames));
  }
  facts.add_member("depth", {{"min", depth.quantile(0.0)},
                             {"median", depth.quantile(0.5)},
                             {"max", depth.quantile(1.0)},
                             {"measured", share}});
}

void add_poses(Facts& facts, const DepthSequence& sequence) {
  std::size_t posed = 0;
  double length = 0.0;
  std::optional<Eigen::Isometry3d> before;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const auto pose = sequence.pose(i);
    if (!pose) continue;
    ++posed;
    if (before) length += (pose->translation() - before->translation()).norm();
    before = pose;
  }
  facts.add("poses",
            posed == 0 ? "none"
                       : fmt::format("{} of {} frames, a path of {:.3f} m", posed, sequence.size(),
                                     length),
            "poses", posed);
  facts.add_member("path_length", length);
}

}  // namespace

Facts sequence_facts(const DepthSequence& sequence, const std::vector<std::size_t>& samples) {
  Facts facts("sequence");
  facts.add_warnings(sequence.warnings());
  facts.add("sequence", sequence.layout(), "layout", sequence.layout());
  add_times(facts, sequence);
  add_camera(facts, sequence.camera());
  const Sample sample = read_sample(sequence, samples);
  add_depth(facts, sample);
  facts.add("colour", sequence.has_color() ? of_read(sample.colored, sample) : "none", "colored",
            sample.colored);
  add_poses(facts, sequence);
  facts.add("unreadable", of_read(sample.unreadable.size(), sample), "unreadable",
            sample.unreadable);
  for (const std::string& why : sample.unreadable) facts.add_row("", why);
  facts.add_member("frames_read", sample.frames);
  return facts;
}

}  // namespace symscene::app
