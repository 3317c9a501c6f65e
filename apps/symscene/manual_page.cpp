#include "manual_page.hpp"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "usage.hpp"

namespace symscene::app {
namespace {

/// Text that roff prints as it is. A line that begins with a dot or a quote would be a request.
std::string roff(const std::string& text) {
  std::string escaped;
  bool at_start = true;
  for (const char c : text) {
    if (at_start && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
    at_start = c == '\n';
  }
  return escaped;
}

std::string entry(const std::string& name, const std::string& kind, const std::string& help) {
  const std::string value = kind.empty() ? "" : fmt::format(" \\fI{}\\fR", roff(kind));
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(name), value, roff(help));
}

std::string options_of(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional())
      text += entry(option->get_name(), "", option->get_description());
    else
      text += entry(fmt::format("{}", fmt::join(names_of(*option), ", ")),
                    option->get_items_expected_max() > 0 ? option->get_type_name() : "",
                    option->get_description());
  }
  return text;
}

std::string synopsis(const CLI::App& command) {
  std::string text = full_name(command) + " [OPTIONS]";
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) text += " " + option->get_name();
  }
  return text;
}

/// The example of the help, as it is typed.
std::string example(const CLI::App& command) {
  if (command.get_footer().empty()) return "";
  return fmt::format(".PP\n.nf\n{}\n.fi\n", roff(command.get_footer()));
}

std::string section(const CLI::App& command) {
  std::string text;
  for (const CLI::App* below : subcommands_of(command)) {
    const bool is_group = !subcommands_of(*below).empty();
    if (!is_group)
      text += fmt::format(".SS {}\n{}.\n.PP\n\\fB{}\\fR\n{}{}", roff(full_name(*below)),
                          roff(below->get_description()), roff(synopsis(*below)),
                          options_of(*below), example(*below));
    text += section(*below);
  }
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  return ".TH SYMSCENE 1 \"\" \"symscene " SYMSCENE_VERSION "\" \"SymScene\"\n" +
         fmt::format(".SH NAME\nsymscene \\- {}\n", roff(app.get_description())) +
         ".SH SYNOPSIS\n\\fBsymscene\\fR [\\fIOPTIONS\\fR] \\fISUBCOMMAND\\fR ...\n" +
         ".SH OPTIONS\n" + options_of(app) + ".SH SUBCOMMANDS\n" + section(app) +
         ".SH EXIT STATUS\n" + entry("0", "", "success") + entry("1", "", "bad input") +
         entry("2", "", "wrong command line or value of an option") +
         entry("3", "", "internal error") + ".SH EXAMPLES\n" + example(app);
}

}  // namespace symscene::app
