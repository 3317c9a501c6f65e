#include "usage.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "core/nearest_name.hpp"

namespace symscene::app {
namespace {

bool is_flag(const std::string& argument) { return argument.size() > 1 && argument[0] == '-'; }

/// "--threads" of "--threads=2".
std::string flag_name(const std::string& argument) {
  return argument.substr(0, argument.find('='));
}

/// Of two names that are equally near, the long one is meant.
std::vector<std::string> long_ones_first(std::vector<std::string> names) {
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name.starts_with("--"); });
  return names;
}

/// What the command line has that the command does not take.
std::optional<std::string> unknown_argument(const CLI::App& app) {
  const CLI::App& command = chosen_command(app);
  const std::vector<std::string> extras = app.remaining(true);
  if (extras.empty()) return std::nullopt;
  const auto flag = std::find_if(extras.begin(), extras.end(), is_flag);
  const bool misses_subcommand = !subcommands_of(command).empty();
  if (misses_subcommand && !is_flag(extras.front()))
    return fmt::format("expected a subcommand, found {}",
                       with_nearest_name(extras.front(), names_of(subcommands_of(command))));
  if (flag != extras.end())
    return fmt::format("expected an option of {}, found {}", full_name(command),
                       with_nearest_name(flag_name(*flag), long_ones_first(flag_names(command))));
  return fmt::format("expected no further argument, found \"{}\"", extras.front());
}

/// What is wrong with the number of values of an option, told by the message of the parser.
std::string wrong_count(const std::string& what) {
  const std::size_t colon = what.find(": ");
  if (colon == std::string::npos)
    return "--" + what.substr(0, what.find(' ')) + ": expected no value, found one";
  const std::string name = what.substr(0, colon);
  if (what.find("At Most", colon) != std::string::npos)
    return fmt::format("{}: expected the option once, found it {} times", name,
                       what.substr(what.rfind(' ') + 1));
  return name + ": expected a value, found none";
}

std::optional<std::string> missing_argument(const CLI::App& app) {
  const CLI::App& command = chosen_command(app);
  if (!subcommands_of(command).empty()) return "expected a subcommand, found none";
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    const std::string kind = option->get_positional() ? "" : " " + option->get_type_name();
    return fmt::format("expected {}{} ({}), found none", option->get_name(), kind,
                       option->get_description());
  }
  return std::nullopt;
}

/// Whether an argument is short flags in one word: -qv.
bool is_combined_flags(const CLI::App& app, const std::string& argument) {
  if (argument.size() < 3 || argument[0] != '-' || argument[1] == '-') return false;
  return std::all_of(argument.begin() + 1, argument.end(), [&](char letter) {
    const CLI::Option* const flag = app.get_option_no_throw(std::string("-") + letter);
    return flag != nullptr && flag->get_items_expected_max() == 0;
  });
}

/// How many of the arguments from `at` on are an option that subcommands repeat, with its value; 0
/// if there is none. Subcommands have no --version.
std::size_t size_of_option(const CLI::App& app, const std::vector<std::string>& arguments,
                           std::size_t at) {
  const std::string& argument = arguments[at];
  if (is_combined_flags(app, argument)) return 1;
  const CLI::Option* const option = app.get_option_no_throw(flag_name(argument));
  if (!is_flag(argument) || option == nullptr || option == app.get_version_ptr()) return 0;
  const bool has_value = option->get_items_expected_max() > 0;
  const bool is_apart = flag_name(argument) == argument;
  return has_value && is_apart && at + 1 < arguments.size() ? 2 : 1;
}

}  // namespace

const CLI::App& chosen_command(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  return *at;
}

std::string full_name(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + " " + command.get_name();
}

std::vector<const CLI::App*> subcommands_of(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> all;
  for (const CLI::App* command : commands) all.push_back(command->get_name());
  return all;
}

std::vector<const CLI::Option*> flags_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return !option->get_positional(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> all;
  for (const std::string& name : option.get_snames()) all.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) all.push_back("--" + name);
  return all;
}

std::vector<std::string> flag_names(const CLI::App& command) {
  std::vector<std::string> all;
  for (const CLI::Option* flag : flags_of(command)) {
    for (std::string& name : names_of(*flag)) all.push_back(std::move(name));
  }
  return all;
}

std::string help_of(const CLI::App& command) {
  // App::help() would print that of the subcommand that was parsed.
  return command.get_formatter()->make_help(&command, full_name(command),
                                            CLI::AppFormatMode::Normal);
}

std::string usage_sentence(const CLI::App& app, const CLI::ParseError& error) {
  const bool misses = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (misses || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    if (const auto unknown = unknown_argument(app)) return *unknown;
    if (const auto missing = missing_argument(app)) return *missing;
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    return wrong_count(error.what());
  return error.what();
}

std::vector<std::string> with_options_behind_subcommand(const CLI::App& app,
                                                        std::vector<std::string> arguments) {
  std::size_t end = 0;  // of the options before the subcommand
  while (end < arguments.size()) {
    const std::size_t size = size_of_option(app, arguments, end);
    if (size == 0) break;
    end += size;
  }
  std::size_t behind = end;
  const CLI::App* at = &app;
  while (behind < arguments.size()) {
    const auto subcommands = subcommands_of(*at);
    const auto found = std::find_if(subcommands.begin(), subcommands.end(), [&](const auto* s) {
      return s->get_name() == arguments[behind];
    });
    if (found == subcommands.end()) break;
    at = *found;
    ++behind;
  }
  if (behind > end)
    std::rotate(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(end),
                arguments.begin() + static_cast<std::ptrdiff_t>(behind));
  return arguments;
}

}  // namespace symscene::app
