#pragma once

#include <filesystem>
#include <string>

#include "session.hpp"

namespace symscene::app {

/// made_by of objects.json: version, command, input, the hashes of the files of the input that
/// decide the result, and options, which are JSON. `input` is a scene or result folder, a file or a
/// sequence of one frame. Warns of files that cannot be read: that does not cost the result.
std::string made_by(const std::string& command, const std::filesystem::path& input,
                    const std::string& options, Session& session);

}  // namespace symscene::app
