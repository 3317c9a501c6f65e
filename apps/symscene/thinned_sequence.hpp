#pragma once

#include <memory>

#include "symscene/io/sequence.hpp"

namespace symscene::app {

/// Every `step`-th frame of a sequence, from the first. The sequence itself where `step` is 1.
std::unique_ptr<DepthSequence> every_nth(std::unique_ptr<DepthSequence> sequence, std::size_t step);

}  // namespace symscene::app
