#include "stitch_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace symscene::app {
namespace {

using Json = nlohmann::ordered_json;

std::size_t accepted(const StitchingResult& result) {
  return static_cast<std::size_t>(std::count_if(
      result.pairs.begin(), result.pairs.end(),
      [](const StitchedPair& pair) { return pair.pose.status == PairStatus::accepted; }));
}

std::string fit_line(const StitchingResult& result, std::span<const std::size_t> numbers) {
  double worst = 0.0, sum = 0.0;
  std::size_t at = 0;
  for (std::size_t k = 0; k < result.frames.size(); ++k) {
    const StitchedFrame& frame = result.frames[k];
    if (!frame.T_world_camera) continue;
    sum += frame.fit.residual;
    if (frame.fit.residual < worst) continue;
    worst = frame.fit.residual;
    at = numbers[k];
  }
  return fmt::format("surfaces fit to {:.1f} mm, worst in frame {} to {:.1f} mm",
                     1e3 * sum / static_cast<double>(result.placed), at, 1e3 * worst);
}

/// The pair that came closest to being accepted.
std::string nearest_line(const StitchingResult& result, std::span<const std::size_t> numbers) {
  const auto best = std::max_element(result.pairs.begin(), result.pairs.end(),
                                     [](const StitchedPair& a, const StitchedPair& b) {
                                       return std::pair(a.pose.inliers.size(), a.pose.matches) <
                                              std::pair(b.pose.inliers.size(), b.pose.matches);
                                     });
  if (best == result.pairs.end()) return "no pair of frames";
  return fmt::format(
      "nearest to a pair were frames {} and {} with {} and {} features: {}, {} of "
      "{} matches agree",
      numbers[best->first], numbers[best->second], result.frames[best->first].features,
      result.frames[best->second].features, to_string(best->pose.status), best->pose.inliers.size(),
      best->pose.matches);
}

/// Keeps the significant digits.
double rounded(double value) { return std::round(value * 1e5) / 1e5; }

Json frame_json(const StitchedFrame& frame, std::size_t number) {
  Json entry = {{"frame", number}, {"features", frame.features}};
  if (frame.T_world_camera) {
    entry["residual"] = rounded(frame.fit.residual);
    entry["inliers"] = rounded(frame.fit.inliers);
  } else {
    entry["left_out"] = frame.reason;
  }
  return entry;
}

Json pair_json(const StitchedPair& pair, std::span<const std::size_t> numbers) {
  return {{"first", numbers[pair.first]},
          {"second", numbers[pair.second]},
          {"status", to_string(pair.pose.status)},
          {"matches", pair.pose.matches},
          {"inliers", pair.pose.inliers.size()},
          {"overlap", rounded(pair.pose.depth.overlap)},
          {"agreement", rounded(pair.pose.depth.agreement)}};
}

}  // namespace

std::vector<std::string> stitch_lines(const StitchingResult& result,
                                      std::span<const std::size_t> numbers) {
  std::vector<std::string> lines{
      fmt::format("{} frames with colour: {} placed; {} of {} pairs accepted", result.frames.size(),
                  result.placed, accepted(result), result.pairs.size())};
  for (std::size_t k = 0; k < result.frames.size(); ++k) {
    if (result.frames[k].T_world_camera) continue;
    lines.push_back(fmt::format("  frame {} left out: {}", numbers[k], result.frames[k].reason));
  }
  lines.push_back(result.placed > 0 ? fit_line(result, numbers) : nearest_line(result, numbers));
  return lines;
}

std::string stitch_json(const StitchingResult& result, std::span<const std::size_t> numbers) {
  Json frames = Json::array(), pairs = Json::array();
  for (std::size_t k = 0; k < result.frames.size(); ++k) {
    frames.push_back(frame_json(result.frames[k], numbers[k]));
  }
  for (const StitchedPair& pair : result.pairs) pairs.push_back(pair_json(pair, numbers));
  const Json object = {{"count", result.frames.size()},
                       {"placed", result.placed},
                       {"converged", result.converged},
                       {"frames", std::move(frames)},
                       {"pairs", std::move(pairs)}};
  return object.dump();
}

}  // namespace symscene::app
