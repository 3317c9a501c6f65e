#pragma once

#include <string>
#include <vector>

#include "arguments.hpp"

namespace symscene::app {

/// docs/options.md: a table per subcommand with name, default, unit, range and help of every option
/// that its --config file may set. A subcommand with the options of an earlier one refers to it.
std::string options_page(const std::vector<ConfigurableCommand>& commands);

}  // namespace symscene::app
