#pragma once

#include <string>
#include <string_view>

namespace symscene {

/// Throws InputError unless the records of a ROS 1 bag (version 2.0) and its index, down to where
/// messages begin, are what they say and lie in the file; librosbag takes that for granted. Inside
/// compressed chunks their checksums watch. `name` stands for the file in messages.
void require_sound_bag(std::string_view bytes, const std::string& name);

}  // namespace symscene
