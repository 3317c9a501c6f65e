#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "reconstruction/measurement.hpp"
#include "symscene/reconstruction/tracking_options.hpp"
#include "symscene/stitching/stitching.hpp"

namespace symscene {

/// The pose of the second frame in the first; none if it is not known.
using PoseOfPair = std::function<std::optional<Eigen::Isometry3d>(std::size_t, std::size_t)>;

/// Joins consecutive frames of a sweep whose features do not: the later frame is tracked in the
/// view of the earlier one, from few features, from no motion and from the motions beside the gap,
/// and searched around them. Their pair gets the status `tracked` if the depth images contradict
/// its pose little more than is usual among the consecutive pairs. Accepted pairs that are
/// contradicted more are rejected. Nothing is done if features join less than half of the
/// consecutive pairs, as too few pairs are left to compare with. `pairs` are those of all frames,
/// as in StitchingResult.
void close_gaps(std::span<const Measurement* const> frames, const StitchingOptions& options,
                const TrackingOptions& tracking, const PoseOfPair& from_features,
                std::vector<StitchedPair>& pairs);

}  // namespace symscene
