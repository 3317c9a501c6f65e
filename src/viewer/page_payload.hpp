#pragma once

#include <string>

#include "symscene/viewer/page.hpp"

namespace symscene {

/// The page's data as JSON that may stand in a script element; arrays are little endian in base64
/// (viewer/README.md).
std::string page_payload(const SegmentationResult& result, const PageOptions& options = {});

}  // namespace symscene
