#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "arguments.hpp"
#include "commands.hpp"
#include "core/nearest_name.hpp"
#include "print.hpp"
#include "usage.hpp"

namespace symscene::app {
namespace {

/// The subcommand of that name. Throws CLI::ValidationError, as for a wrong value, if there is
/// none.
const CLI::App* subcommand_of(const CLI::App& command, const std::string& name) {
  const std::vector<const CLI::App*> subcommands = subcommands_of(command);
  for (const CLI::App* subcommand : subcommands) {
    if (subcommand->get_name() == name) return subcommand;
  }
  throw CLI::ValidationError(
      "COMMAND", fmt::format("expected a subcommand of {}, found {}", full_name(command),
                             with_nearest_name(name, names_of(subcommands))));
}

}  // namespace

void add_help(CommandLine& line) {
  const auto words = std::make_shared<std::vector<std::string>>();
  Arguments arguments(line, "help", "Print the help of the command or of a subcommand",
                      "symscene help segment\n"
                      "  symscene help calibrate depth");
  arguments.words(*words, "COMMAND", "subcommand (default: all, in one line each)");
  arguments.run([&line, words] {
    const CLI::App* command = &line.parser;
    for (const std::string& word : *words) command = subcommand_of(*command, word);
    print_output(help_of(*command));
  });
}

}  // namespace symscene::app
