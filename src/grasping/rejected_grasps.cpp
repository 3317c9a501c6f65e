#include "rejected_grasps.hpp"

#include <array>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

std::vector<RejectedGrasp> some_of_each_reason(const std::vector<RejectedGrasp>& all, int most) {
  std::array<std::vector<RejectedGrasp>, grasp_rejections> by_reason;
  for (const RejectedGrasp& rejected : all)
    by_reason.at(static_cast<std::size_t>(rejected.reason)).push_back(rejected);
  std::vector<RejectedGrasp> kept;
  for (const std::vector<RejectedGrasp>& alike : by_reason) {
    for (const Index i : evenly_spread(static_cast<Index>(alike.size()), static_cast<Index>(most)))
      kept.push_back(alike[i]);
  }
  return kept;
}

}  // namespace symscene
