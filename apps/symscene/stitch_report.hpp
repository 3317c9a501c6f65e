#pragma once

#include <span>
#include <string>
#include <vector>

#include "symscene/stitching/stitching.hpp"

namespace symscene::app {

/// Lines about the frames and pairs. `numbers` are the numbers of the frames in their sequence.
std::vector<std::string> stitch_lines(const StitchingResult& result,
                                      std::span<const std::size_t> numbers);

/// Status of each frame and of each pair as a JSON object.
std::string stitch_json(const StitchingResult& result, std::span<const std::size_t> numbers);

}  // namespace symscene::app
