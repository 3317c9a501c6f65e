#pragma once

#include <string>

namespace CLI {
class App;
}

namespace symscene::app {

/// The manual page of the command with all subcommands, in the language of man(7).
std::string manual_page(const CLI::App& app);

}  // namespace symscene::app
