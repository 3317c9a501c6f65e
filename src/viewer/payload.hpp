#pragma once

#include <nlohmann/json.hpp>

#include "symscene/viewer/page.hpp"

namespace symscene {

/// What the page shows, as the viewer's JavaScript reads it.
nlohmann::json make_payload(const SegmentationResult& result, const PageOptions& options);

}  // namespace symscene
