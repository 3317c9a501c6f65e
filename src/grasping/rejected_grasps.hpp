#pragma once

#include <vector>

#include "symscene/core/grasp.hpp"

namespace symscene {

/// Of each reason at most `most` of the candidates that failed by it, evenly spread over them, in
/// the order of the reasons.
std::vector<RejectedGrasp> some_of_each_reason(const std::vector<RejectedGrasp>& all, int most);

}  // namespace symscene
