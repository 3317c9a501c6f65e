#pragma once

#include <string>

#include "io/option_fields.hpp"

namespace symscene::app {

/// All fields as JSON that read_config() reads back. If `annotated`, a comment behind each gives
/// its unit, range and help.
std::string format_config(const OptionFields& fields, bool annotated);

/// What made an output, as JSON: version, command and all options; `frames`, JSON too, lists the
/// status of its frames, `sensor` tells their sensor.
std::string describe_run(const std::string& command, const OptionFields& fields,
                         const std::string& frames = "", const std::string& sensor = "");

}  // namespace symscene::app
