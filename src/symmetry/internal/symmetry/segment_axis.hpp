#pragma once

#include <optional>

#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// The fitted axis of a segment that passes most bounds; of several accepted ones that of the
/// lowest occlusion residual, of several rejected ones that of the lowest symmetry residual.
struct SegmentAxis {
  AxisJudgement judgement;
  RotationalCandidate candidate;
};

/// Fits an axis to a segment from several initial axes (section 3.5.2). Points on the rim of the
/// segment, whose normals are least accurate, are not fitted. The parameters are those of
/// detect_rotational().
SegmentAxis segment_axis(const PointCloud& cloud, const PointIndices& segment,
                         const DistanceField& field, const std::optional<Eigen::Vector3d>& up,
                         const RotationalDetectionOptions& options);

}  // namespace symscene
