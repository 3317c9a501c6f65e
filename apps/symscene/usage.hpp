#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
class ParseError;
}  // namespace CLI

namespace symscene::app {

/// The subcommand that the command line has chosen, the innermost of nested ones; `app` without
/// one.
const CLI::App& chosen_command(const CLI::App& app);

/// "symscene" and the names of the subcommands up to this one.
std::string full_name(const CLI::App& command);

/// The subcommands in the order of the help.
std::vector<const CLI::App*> subcommands_of(const CLI::App& command);

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands);

/// The options that begin with a dash.
std::vector<const CLI::Option*> flags_of(const CLI::App& command);

/// The names of an option: "-o", "--output".
std::vector<std::string> names_of(const CLI::Option& option);

/// The names of all options that begin with a dash.
std::vector<std::string> flag_names(const CLI::App& command);

/// The help of a subcommand, or of the whole command.
std::string help_of(const CLI::App& command);

/// What is wrong with the command line, in one sentence: expected and found. Names the option or
/// subcommand that is most like one that does not exist.
std::string usage_sentence(const CLI::App& app, const CLI::ParseError& error);

/// The arguments with options of the whole command, which may stand before the subcommand, behind
/// it, where the subcommand takes them.
std::vector<std::string> with_options_behind_subcommand(const CLI::App& app,
                                                        std::vector<std::string> arguments);

}  // namespace symscene::app
