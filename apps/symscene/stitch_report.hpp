#pragma once

#include <span>
#include <string>
#include <vector>

#include "symscene/stitching/stitching.hpp"

namespace symscene::app {

/// What became of frames and pairs, for a person. `numbers` are the frames' in their sequence.
std::vector<std::string> stitch_lines(const StitchingResult& result,
                                      std::span<const std::size_t> numbers);

/// The same, frame by frame and pair by pair, as a JSON object.
std::string stitch_json(const StitchingResult& result, std::span<const std::size_t> numbers);

}  // namespace symscene::app
