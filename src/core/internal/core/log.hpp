#pragma once

#include <functional>
#include <string_view>

namespace symscene {

enum class LogLevel { debug, info, warning };

/// Receives what the library has to say. Called from any thread.
using LogSink = std::function<void(LogLevel, std::string_view)>;

/// Replaces the sink (an empty one drops everything, the default) and returns the one before. Not
/// to be called while a stage runs.
LogSink set_log_sink(LogSink sink);

/// Hands a message to the sink.
void log(LogLevel level, std::string_view message);

}  // namespace symscene
