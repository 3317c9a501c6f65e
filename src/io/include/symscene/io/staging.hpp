#pragma once

namespace symscene {

/// Outputs are written to a temporary file or folder beside them. From now on it is removed if
/// SIGINT, SIGTERM or SIGHUP ends the process; SIGXFSZ is ignored, so that a file that grows beyond
/// a limit is an error. For programs of one purpose: it replaces the handlers of these signals,
/// except where they are ignored.
void remove_staging_on_signals();

}  // namespace symscene
