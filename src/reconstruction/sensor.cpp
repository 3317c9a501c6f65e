#include "symscene/reconstruction/sensor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "core/image_checks.hpp"
#include "core/median.hpp"
#include "symscene/core/depth_noise.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr double min_depth = 0.1;   // of a pixel [m]
constexpr double max_depth = 20.0;  // of a pixel [m]

constexpr double min_noise_share = 0.5;  // of a variance that rounding contributes to

constexpr std::array<std::pair<Sensor, const char*>, 3> names{
    {{Sensor::structured_light, "structured-light"},
     {Sensor::stereo, "stereo"},
     {Sensor::time_of_flight, "tof"}}};

/// The noise of a patch about its plane.
struct Patch {
  double depth = 0.0;
  double deviation = 0.0;
  double correlation = 0.0;  ///< of the residuals of neighbours in a row
};

/// A square of pixels of a depth image.
class PatchFit {
 public:
  PatchFit(const DepthFrame& frame, const CameraIntrinsics& camera,
           const SensorEstimationOptions& options)
      : frame_(frame),
        camera_(camera),
        edge_(static_cast<std::size_t>(options.patch)),
        min_count_(options.min_filled * static_cast<double>(edge_ * edge_)) {}

  /// The plane of least squares, which is linear in inverse depth. None if too little is measured.
  std::optional<Patch> fit(std::size_t left, std::size_t top) {
    read(left, top);
    if (static_cast<double>(count_) < min_count_) return {};
    const Eigen::Vector3d plane = normal_matrix_.ldlt().solve(right_);
    return patch(plane);
  }

 private:
  Eigen::Vector3d terms(std::size_t k) const {
    const double middle = 0.5 * static_cast<double>(edge_ - 1);
    return {1.0, static_cast<double>(k % edge_) - middle, static_cast<double>(k / edge_) - middle};
  }

  void read(std::size_t left, std::size_t top) {
    inverse_.assign(edge_ * edge_, 0.0);
    normal_matrix_.setZero();
    right_.setZero();
    count_ = 0;
    for (std::size_t k = 0; k < inverse_.size(); ++k) {
      const double z = frame_.depth[(top + k / edge_) * camera_.width + left + k % edge_];
      if (!(z > min_depth && z < max_depth)) continue;
      inverse_[k] = 1.0 / z;
      const Eigen::Vector3d row = terms(k);
      normal_matrix_ += row * row.transpose();
      right_ += row * inverse_[k];
      ++count_;
    }
  }

  Patch patch(const Eigen::Vector3d& plane) const {
    double squares = 0.0, products = 0.0, before = 0.0;
    std::size_t pairs = 0;
    for (std::size_t k = 0; k < inverse_.size(); ++k) {
      const bool measured = inverse_[k] > 0.0;
      const double residual = measured ? inverse_[k] - plane.dot(terms(k)) : 0.0;
      squares += residual * residual;
      if (measured && k % edge_ != 0 && inverse_[k - 1] > 0.0) {
        products += before * residual;
        ++pairs;
      }
      before = residual;
    }
    const double variance = squares / static_cast<double>(count_ - 3);
    const double depth = static_cast<double>(count_) / right_[0];
    const double covariance = products / static_cast<double>(std::max<std::size_t>(pairs, 1));
    return {depth, std::sqrt(variance) * depth * depth,
            variance > 0.0 ? covariance / variance : 0.0};
  }

  const DepthFrame& frame_;
  const CameraIntrinsics& camera_;
  std::size_t edge_;
  double min_count_;
  std::vector<double> inverse_;  ///< depths, 0 where nothing was measured [1/m]
  Eigen::Matrix3d normal_matrix_;
  Eigen::Vector3d right_;
  std::size_t count_ = 0;
};

std::vector<Patch> patches_of(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                              const SensorEstimationOptions& options) {
  std::vector<Patch> patches;
  const auto step = static_cast<std::size_t>(options.patch);
  for (const DepthFrame& frame : frames) {
    require_pixels(frame.depth.size(), camera, "depth image");
    PatchFit fit(frame, camera, options);
    for (std::size_t top = 0; top + step <= camera.height; top += step) {
      for (std::size_t left = 0; left + step <= camera.width; left += step) {
        const auto patch = fit.fit(left, top);
        if (patch && patch->deviation < options.max_relative_deviation * patch->depth)
          patches.push_back(*patch);
      }
    }
  }
  return patches;
}

/// The smooth patches of each range of depths: those of least residual.
std::vector<std::vector<Patch>> smooth_patches(std::vector<Patch> patches,
                                               const SensorEstimationOptions& options) {
  const auto bin = [&](const Patch& patch) {
    return static_cast<int>(std::floor(std::log(patch.depth) / options.depth_bin));
  };
  std::sort(patches.begin(), patches.end(), [&](const Patch& a, const Patch& b) {
    return std::pair(bin(a), a.deviation) < std::pair(bin(b), b.deviation);
  });
  std::vector<std::vector<Patch>> smooth;
  for (auto begin = patches.begin(); begin != patches.end();) {
    const auto end = std::find_if(begin, patches.end(),
                                  [&](const Patch& patch) { return bin(patch) != bin(*begin); });
    if (end - begin >= options.min_patches) {
      const auto count = std::ceil(options.smooth_share * static_cast<double>(end - begin));
      smooth.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(count));
    }
    begin = end;
  }
  return smooth;
}

/// The step in which depths are stored: the smallest difference that occurs among some of them [m].
/// 0 without two different depths.
double depth_step(std::span<const DepthFrame> frames) {
  constexpr std::size_t some = 20000;
  std::size_t pixels = 0;
  for (const DepthFrame& frame : frames) pixels += frame.depth.size();
  const std::size_t stride = pixels / some + 1;
  std::vector<double> depths;
  for (const DepthFrame& frame : frames) {
    for (std::size_t i = 0; i < frame.depth.size(); i += stride) {
      const double z = frame.depth[i];
      if (z > min_depth && z < max_depth) depths.push_back(z);
    }
  }
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  double step = depths.size() < 2 ? 0.0 : max_depth;
  for (std::size_t k = 1; k < depths.size(); ++k) step = std::min(step, depths[k] - depths[k - 1]);
  return step;
}

/// The standard deviation of values that are rounded to multiples of a step.
double rounding_deviation(double step) { return step / std::sqrt(12.0); }

template <class Value>
double median_of(const std::vector<Patch>& patches, const Value& value) {
  std::vector<double> values;
  for (const Patch& patch : patches) values.push_back(value(patch));
  return median(std::move(values)).value_or(0.0);
}

/// The power law through the samples: the median of the slopes of all pairs (Sen 1968).
void fit_power_law(const SensorEstimationOptions& options, SensorEstimate& estimate) {
  std::vector<double> slopes, offsets;
  const auto& samples = estimate.samples;
  for (std::size_t a = 0; a < samples.size(); ++a) {
    for (std::size_t b = a + 1; b < samples.size(); ++b) {
      const double ratio = samples[b].depth / samples[a].depth;
      if (ratio >= options.min_depth_ratio)
        slopes.push_back(std::log(samples[b].deviation / samples[a].deviation) / std::log(ratio));
    }
  }
  estimate.too_little = slopes.empty();
  estimate.exponent = median(std::move(slopes)).value_or(0.0);
  for (const DepthNoiseSample& sample : samples)
    offsets.push_back(std::log(sample.deviation) - estimate.exponent * std::log(sample.depth));
  estimate.deviation_at_1m = samples.empty() ? 0.0 : std::exp(*median(std::move(offsets)));
}

/// Whether all smooth surfaces have no more noise than rounding gives.
bool is_rounded(const SensorEstimationOptions& options, const SensorEstimate& estimate) {
  if (estimate.samples.empty()) return estimate.rounded > 0;
  const double rounding = rounding_deviation(estimate.step);
  return std::all_of(estimate.samples.begin(), estimate.samples.end(), [&](const auto& sample) {
    return std::hypot(sample.deviation, rounding) <= options.min_deviation;
  });
}

/// Names the sensor, or the reason why none is named.
void name_sensor(const SensorEstimationOptions& options, SensorEstimate& estimate) {
  if (is_rounded(options, estimate)) {
    estimate.too_little = true;
    estimate.reason = "the depths have no noise beyond that of rounding";
  } else if (estimate.too_little && estimate.rounded > 0) {
    estimate.reason = "the noise exceeds that of rounding at too few depths";
  } else if (estimate.too_little) {
    estimate.reason = "the frames show too few smooth surfaces at different depths";
  } else if (estimate.exponent >= options.min_quadratic_exponent) {
    estimate.sensor = estimate.correlation >= options.min_stereo_correlation
                          ? Sensor::stereo
                          : Sensor::structured_light;
  } else if (estimate.exponent <= options.max_constant_exponent &&
             estimate.correlation <= options.max_independent) {
    estimate.sensor = Sensor::time_of_flight;
  } else {
    estimate.reason = "no model explains the noise";
  }
}

}  // namespace

const char* to_string(Sensor sensor) {
  return std::find_if(names.begin(), names.end(),
                      [&](const auto& name) { return name.first == sensor; })
      ->second;
}

Sensor parse_sensor(const std::string& name) {
  for (const auto& [sensor, known] : names) {
    if (name == known) return sensor;
  }
  throw InputError("sensor", "structured-light, stereo or tof", name);
}

void SensorEstimationOptions::validate() const {
  check_fields(*this);
  require_option(max_constant_exponent < min_quadratic_exponent, "max_constant_exponent",
                 "less than min_quadratic_exponent", max_constant_exponent);
}

SensorEstimate estimate_sensor(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                               const SensorEstimationOptions& options) {
  options.validate();
  SensorEstimate estimate;
  std::vector<double> correlations;
  const auto bins = smooth_patches(patches_of(frames, camera, options), options);
  estimate.step = depth_step(frames);
  const double rounding_variance = std::pow(rounding_deviation(estimate.step), 2);
  for (const std::vector<Patch>& smooth : bins) {
    const double deviation = median_of(smooth, [](const Patch& p) { return p.deviation; });
    const double depth = median_of(smooth, [](const Patch& p) { return p.depth; });
    const double variance = deviation * deviation - rounding_variance;
    if (variance < min_noise_share * deviation * deviation) {
      ++estimate.rounded;
      continue;
    }
    estimate.samples.push_back(
        {depth, std::max(std::sqrt(variance), 1e-6), static_cast<std::uint32_t>(smooth.size())});
    for (const Patch& patch : smooth) correlations.push_back(patch.correlation);
  }
  estimate.correlation = median(std::move(correlations)).value_or(0.0);
  fit_power_law(options, estimate);
  name_sensor(options, estimate);
  return estimate;
}

double depth_noise(Sensor sensor, const CameraIntrinsics& camera, double depth,
                   const SensorEstimationOptions& options) {
  switch (sensor) {
    case Sensor::structured_light:
      return structured_light_noise;
    case Sensor::stereo:
      return options.stereo_disparity / (camera.fx * options.stereo_baseline);
    case Sensor::time_of_flight:
      return std::max(structured_light_noise, options.time_of_flight_deviation / (depth * depth));
  }
  return structured_light_noise;
}

DepthFrame without_flying_pixels(DepthFrame frame, const CameraIntrinsics& camera, double step) {
  require_pixels(frame.depth.size(), camera, "depth image");
  const std::vector<float> measured = frame.depth;
  const std::size_t width = camera.width;
  const auto between = [&](std::size_t i, std::size_t offset) {
    const float z = measured[i], a = measured[i - offset], b = measured[i + offset];
    const float least = static_cast<float>(step) * z;
    return a > 0.0F && b > 0.0F && (z - a) * (b - z) > 0.0F &&
           std::min(std::abs(z - a), std::abs(b - z)) > least;
  };
  for (std::size_t v = 1; v + 1 < camera.height; ++v) {
    for (std::size_t u = 1; u + 1 < width; ++u) {
      const std::size_t i = v * width + u;
      if (!(measured[i] > 0.0F)) continue;
      if (between(i, 1) || between(i, width) || between(i, width + 1) || between(i, width - 1))
        frame.depth[i] = 0.0F;
    }
  }
  return frame;
}

}  // namespace symscene
