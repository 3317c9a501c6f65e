#pragma once

#include <nlohmann/json.hpp>

#include "symscene/viewer/run_page.hpp"

namespace symscene {

/// A run as the page reads it (viewer/README.md). Throws InputError as render_run_page() does.
nlohmann::json run_payload(const RunRecording& recording, const std::string& title);

}  // namespace symscene
