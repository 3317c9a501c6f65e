#pragma once

#include <memory>

#include "symscene/io/sequence.hpp"

namespace symscene {

/// A sequence whose frames are those of `measured`, rectified. Throws InputError if the camera is
/// not valid.
std::unique_ptr<DepthSequence> rectified_sequence(std::unique_ptr<DepthSequence> measured,
                                                  const CameraModel& camera);

}  // namespace symscene
