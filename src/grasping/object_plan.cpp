#include "object_plan.hpp"

#include <algorithm>
#include <array>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

bool is_better(const Grasp& a, const Grasp& b) { return a.quality > b.quality; }

PointIndices some_of_each_reason(std::span<const GraspRejection> reasons, int most) {
  std::array<PointIndices, grasp_rejections> by_reason;
  for (std::size_t i = 0; i < reasons.size(); ++i)
    by_reason.at(static_cast<std::size_t>(reasons[i])).push_back(static_cast<Index>(i));
  PointIndices kept;
  for (const PointIndices& alike : by_reason) {
    for (const Index i : evenly_spread(static_cast<Index>(alike.size()), static_cast<Index>(most)))
      kept.push_back(alike[i]);
  }
  return kept;
}

GraspPlan joined(const std::vector<ObjectPlan>& objects) {
  GraspPlan plan;
  for (const ObjectPlan& object : objects) {
    plan.grasps.insert(plan.grasps.end(), object.grasps.begin(), object.grasps.end());
    plan.rejected.insert(plan.rejected.end(), object.rejected.begin(), object.rejected.end());
    plan.objects.push_back(object.summary);
  }
  std::stable_sort(plan.grasps.begin(), plan.grasps.end(), is_better);
  return plan;
}

}  // namespace symscene
