#pragma once

#include "symscene/viewer/run_page.hpp"

namespace symscene {

/// Throws InputError unless render_run_page() can draw the recording.
void require_playable(const RunRecording& recording);

}  // namespace symscene
