#pragma once

#include <cstdint>

namespace symscene {

/// Names of the members of times and durations: `secs` and `nsecs`, or `sec` and `nanosec`.
enum class RosVersion : std::uint8_t { ros1, ros2 };

}  // namespace symscene
