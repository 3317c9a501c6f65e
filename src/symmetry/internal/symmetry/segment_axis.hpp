#pragma once

#include <optional>

#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// How the best axis of a segment was judged: no axis was fitted, the first bound that it fails, or
/// none. In the order of judgement, so that a later one is better.
enum class AxisOutcome { no_fit, symmetry, perpendicularity, coverage, occlusion, accepted };

/// The fitted axis of a segment that passes most bounds; of several accepted ones that of the
/// lowest occlusion residual, of several rejected ones that of the lowest symmetry residual.
struct SegmentAxis {
  AxisOutcome outcome = AxisOutcome::no_fit;
  RotationalCandidate candidate;
};

/// Fits an axis to a segment from several initial axes (section 3.5.2). Points on the rim of the
/// segment, whose normals are least accurate, are not fitted. The parameters are those of
/// detect_rotational().
SegmentAxis segment_axis(const PointCloud& cloud, const PointIndices& segment,
                         const DistanceField& field, const std::optional<Eigen::Vector3d>& up,
                         const RotationalDetectionOptions& options);

}  // namespace symscene
