#pragma once

#include <string>

namespace CLI {
class App;
}

namespace symscene::app {

/// A script for bash that completes subcommands, options and their values.
std::string bash_completion(const CLI::App& app);

/// The same for zsh, a file of its function path.
std::string zsh_completion(const CLI::App& app);

}  // namespace symscene::app
