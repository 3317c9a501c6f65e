#pragma once

#include <string>

#include "symscene/core/error.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene::app {

/// Throws InputError, with `expected` for the input that is missing, if an option is given that
/// only a sequence of depth images has a use for.
inline void require_no_camera(const SequenceOptions& source, const std::string& expected) {
  if (source.intrinsics || source.camera) throw InputError("--intrinsics", expected, "none");
  if (source.depth_scale) throw InputError("--depth-scale", expected, "none");
}

}  // namespace symscene::app
