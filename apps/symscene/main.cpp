#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "arguments.hpp"
#include "commands.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/staging.hpp"

namespace {

using symscene::InputError;

enum ExitCode { ok = 0, bad_input = 1, bad_usage = 2, internal_error = 3 };

/// "symscene" and the names of the subcommands.
std::string name_of(const CLI::App& app) {
  std::string name = "symscene";
  for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().front();
    name += " " + at->get_name();
  }
  return name;
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
  return fail(bad_usage, app, fmt::format("{} (see {} --help)", error.what(), name_of(app)));
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

void add_commands(symscene::app::CommandLine& line) {
  CLI::App& app = line.parser;
  app.name("symscene");
  app.set_version_flag("--version", "symscene " SYMSCENE_VERSION);
  app.require_subcommand(1);
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
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const auto commands = app.get_subcommands();
    fmt::print("{}", commands.empty() ? app.help() : commands.front()->help("symscene"));
  } catch (const CLI::CallForVersion& version) {
    fmt::print("{}\n", version.what());
  } catch (const CLI::Success&) {
  }
}

ExitCode run(CLI::App& app, int argc, const char* const* argv) {
  try {
    parse_and_run(app, argc, argv);
    flush_output();
    return ok;
  } catch (const CLI::ParseError& error) {
    return fail_usage(app, error);
  } catch (const InputError& error) {
    return fail(bad_input, app, error.what());
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
  CLI::App app{"Finds the objects on a cluttered table by their symmetries."};
  symscene::app::CommandLine line{app, {}};
  add_commands(line);
  return run(app, argc, argv);
}
