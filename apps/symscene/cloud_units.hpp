#pragma once

#include <optional>
#include <string>

#include "symscene/workflow/segment_options.hpp"

namespace symscene::app {

/// Checks whether a cloud has the size and the spacing of a scene in its unit, [m] or, with
/// `is_scaled`, [mm] that were scaled to metres. Throws InputError, with the name of the file, if
/// nothing of it can be segmented as its points are too far apart, or all of it is smaller than an
/// object. Returns a sentence if it is as large as a building, where the other unit is more likely.
std::optional<std::string> check_cloud_units(const Points& positions, bool is_scaled,
                                             const std::string& file,
                                             const PipelineOptions& options);

}  // namespace symscene::app
