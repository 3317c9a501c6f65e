#include "range_options.hpp"

#include <algorithm>

namespace symscene {
namespace {

constexpr double truncation_voxels = 4.0;
constexpr double max_voxel_size = 0.05;  // [m]

}  // namespace

double near_depth(const Measurement& measurement) {
  std::vector<std::uint32_t> depths;
  for (const std::uint32_t packed : measurement.packed) {
    if (packed != 0) depths.push_back(packed >> 16);
  }
  if (depths.empty()) return 0.0;
  const auto tenth = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 10);
  std::nth_element(depths.begin(), tenth, depths.end());
  return static_cast<double>(*tenth) * double{Measurement::depth_unit};
}

ReconstructionOptions fitted_to_depth(ReconstructionOptions options, double depth) {
  TsdfOptions& tsdf = options.tsdf;
  const double deviation = options.measurement.deviation(depth);
  const double voxel = std::min(tsdf.voxel_sigmas * deviation, max_voxel_size);
  if (voxel <= tsdf.voxel_size) return options;
  tsdf.voxel_size = voxel;
  tsdf.truncation = std::max(tsdf.truncation, truncation_voxels * voxel);
  tsdf.max_truncation =
      std::max({tsdf.max_truncation, tsdf.truncation, tsdf.truncation_sigmas * deviation});
  options.occupancy.free_margin = std::max(options.occupancy.free_margin, deviation);
  return options;
}

}  // namespace symscene
