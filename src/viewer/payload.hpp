#pragma once

#include <nlohmann/json.hpp>

#include "symscene/viewer/page.hpp"

namespace symscene {

/// The page's data as its JavaScript reads them (viewer/README.md).
nlohmann::json make_payload(const SegmentationResult& result, const PageOptions& options);

}  // namespace symscene
