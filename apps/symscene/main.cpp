#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "arguments.hpp"
#include "commands.hpp"
#include "optional_parts.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/staging.hpp"
#include "usage.hpp"

namespace {

using symscene::InputError;

enum ExitCode { ok = 0, bad_input = 1, bad_usage = 2, internal_error = 3 };

std::string name_of(const CLI::App& app) {
  return symscene::app::full_name(symscene::app::chosen_command(app));
}

/// Prints one line on standard error, whatever characters the sentence has.
ExitCode fail(ExitCode code, const CLI::App& app, std::string sentence) {
  for (char& c : sentence) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  fmt::print(stderr, "{}: {}\n", name_of(app), sentence);
  return code;
}

ExitCode fail_usage(const CLI::App& app, const CLI::ParseError& error) {
  return fail(
      bad_usage, app,
      fmt::format("{} (see {} --help)", symscene::app::usage_sentence(app, error), name_of(app)));
}

/// The value of an option is wrong in itself or beside another one; the rest is bad input.
ExitCode fail_input(const CLI::App& app, const InputError& error) {
  const bool names_option = std::string_view(error.where()).starts_with("--");
  return fail(names_option ? bad_usage : bad_input, app, error.what());
}

#if !defined(SYMSCENE_HAS_SIMULATION) || !defined(SYMSCENE_HAS_EVALUATION)
/// A subcommand that this build leaves out reports how to get it.
void add_missing(CLI::App& app, const std::string& name) {
  CLI::App* command = app.add_subcommand(name, "Not in this build: ./run build adds it");
  command->allow_extras();
  command->callback([name] {
    throw InputError("symscene " + name, "a build with the evaluation (run ./run build)",
                     "one without it");
  });
}
#endif

/// `before`: options that stand before the subcommand.
void add_commands(symscene::app::CommandLine& line, symscene::app::SharedOptions& before) {
  CLI::App& app = line.parser;
  app.name("symscene");
  app.set_version_flag("--version", symscene::app::version_text(),
                       "print the version, and which optional parts this build has");
  app.require_subcommand(1);
  symscene::app::add_options_of_all(line, before);
  app.footer(
      "Example:\n"
      "  symscene simulate -o scene && symscene segment scene -o result &&\n"
      "    symscene view result -o page.html");
#define SYMSCENE_ADD_SUBCOMMAND(name) symscene::app::add_##name(line);
#define SYMSCENE_ADD_MISSING(name) add_missing(app, #name);
  SYMSCENE_SUBCOMMANDS(SYMSCENE_ADD_SUBCOMMAND)
#ifdef SYMSCENE_HAS_SIMULATION
  SYMSCENE_SIMULATION_SUBCOMMANDS(SYMSCENE_ADD_SUBCOMMAND)
#else
  SYMSCENE_SIMULATION_SUBCOMMANDS(SYMSCENE_ADD_MISSING)
#endif
#ifdef SYMSCENE_HAS_EVALUATION
  SYMSCENE_EVALUATION_SUBCOMMANDS(SYMSCENE_ADD_SUBCOMMAND)
#else
  SYMSCENE_EVALUATION_SUBCOMMANDS(SYMSCENE_ADD_MISSING)
#endif
#undef SYMSCENE_ADD_MISSING
#undef SYMSCENE_ADD_SUBCOMMAND
}

/// Output that cannot be written, to a full disk for example, is an error.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw InputError("standard output", "a stream that can be written", "a write error");
}

/// CLI11 reports help, version and --dump-config by exceptions.
void parse_and_run(CLI::App& app, int argc, const char* const* argv) {
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    std::vector<std::string> ordered =
        symscene::app::with_options_behind_subcommand(app, arguments);
    std::reverse(ordered.begin(), ordered.end());  // as the parser wants them
    app.parse(std::move(ordered));
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", symscene::app::help_of(symscene::app::chosen_command(app)));
  } catch (const CLI::CallForVersion& version) {
    fmt::print("{}\n", version.what());
  } catch (const CLI::Success&) {
  }
}

ExitCode run(symscene::app::CommandLine& line, int argc, const char* const* argv) {
  CLI::App& app = line.parser;
  symscene::app::SharedOptions before;
  try {
    add_commands(line, before);
    parse_and_run(app, argc, argv);
    flush_output();
    return ok;
  } catch (const CLI::ParseError& error) {
    return fail_usage(app, error);
  } catch (const InputError& error) {
    return fail_input(app, error);
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(bad_input, app,
                fmt::format("{}: {}", error.path1().string(), error.code().message()));
  } catch (const std::bad_alloc&) {
    return fail(internal_error, app, "out of memory");
  } catch (const std::exception& error) {
    return fail(internal_error, app, fmt::format("internal error: {}", error.what()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  symscene::remove_staging_on_signals();
  try {
    CLI::App app{"Finds the objects on a cluttered table by their symmetries."};
    symscene::app::CommandLine line{app, {}};
    return run(line, argc, argv);
  } catch (...) {  // no memory for the parser, or for a sentence
    std::fputs("symscene: out of memory\n", stderr);
    return internal_error;
  }
}
