#include "core/log.hpp"

#include <utility>

namespace symscene {
namespace {

LogSink& current_sink() {
  static LogSink sink;
  return sink;
}

}  // namespace

LogSink set_log_sink(LogSink sink) { return std::exchange(current_sink(), std::move(sink)); }

void log(LogLevel level, std::string_view message) {
  if (const LogSink& sink = current_sink()) sink(level, message);
}

}  // namespace symscene
