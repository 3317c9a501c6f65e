#pragma once

namespace symscene {

/// The warning of a workspace whose scene has no occupancy.
constexpr const char* no_occupancy_warning =
    "no occupancy map: all space off the surface counts as never seen";

}  // namespace symscene
