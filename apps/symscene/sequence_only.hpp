#pragma once

#include <string>

#include "symscene/core/error.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene::app {

/// The first option that is given and only a sequence of depth images has a use for; none: nullptr.
inline const char* given_camera_option(const SequenceOptions& source) {
  if (source.intrinsics || source.camera) return "--intrinsics";
  return source.depth_scale ? "--depth-scale" : nullptr;
}

/// Throws InputError, with `expected` for the input that is missing, if one is given.
inline void require_no_camera(const SequenceOptions& source, const std::string& expected) {
  if (const char* given = given_camera_option(source)) throw InputError(given, expected, "none");
}

}  // namespace symscene::app
