#pragma once

#include <span>
#include <vector>

#include "symscene/core/grasp.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// What became of one object's candidates.
struct ObjectPlan {
  std::vector<Grasp> grasps;
  std::vector<RejectedGrasp> rejected;
  ObjectGraspSummary summary;
};

/// By descending quality.
bool is_better(const Grasp& a, const Grasp& b);

/// Indices of at most `most` of the candidates that failed by each reason, evenly spread over them,
/// in the order of the reasons.
PointIndices some_of_each_reason(std::span<const GraspRejection> reasons, int most);

/// The grasps of all objects in descending order of quality, without times.
GraspPlan joined(const std::vector<ObjectPlan>& objects);

}  // namespace symscene
