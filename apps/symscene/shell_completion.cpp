#include "shell_completion.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "text_list.hpp"
#include "usage.hpp"

namespace symscene::app {
namespace {

/// How a shell writes what completes a word.
struct Shell {
  std::string files, folders, nothing;
  std::string words;  ///< with a place for the words
};

const Shell bash{.files = "mapfile -t COMPREPLY < <(compgen -f -- \"$current\")",
                 .folders = "mapfile -t COMPREPLY < <(compgen -d -- \"$current\")",
                 .nothing = "COMPREPLY=()",
                 .words = "mapfile -t COMPREPLY < <(compgen -W \"{}\" -- \"$current\")"};
const Shell zsh{
    .files = "_files", .folders = "_files -/", .nothing = "return 1", .words = "compadd -- {}"};

std::string completes_words(const Shell& shell, const std::vector<std::string>& words) {
  return fmt::format(fmt::runtime(shell.words), fmt::join(words, " "));
}

/// Metavariables are in capitals, words to type are not.
bool is_word(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

/// What completes the value of an option, by its metavariable: FILE, FOLDER, one|two, NAME|FILE.
std::string completes_value(const Shell& shell, const std::string& kind) {
  const std::vector<std::string> parts = separated(kind, '|');
  const auto has = [&](const char* part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  };
  if (has("FILE")) return shell.files;
  if (has("FOLDER")) return shell.folders;
  if (!kind.empty() && std::all_of(parts.begin(), parts.end(), is_word))
    return completes_words(shell, parts);
  return shell.nothing;
}

/// The command and all below it.
std::vector<const CLI::App*> all_commands(const CLI::App& command) {
  std::vector<const CLI::App*> all{&command};
  for (const CLI::App* below : subcommands_of(command)) {
    const auto further = all_commands(*below);
    all.insert(all.end(), further.begin(), further.end());
  }
  return all;
}

/// Lines that turn `line` into the name of the subcommand as far as it is typed.
std::string walk(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : all_commands(app)) {
    if (command != &app) names.push_back(fmt::format("\"{}\"", full_name(*command)));
  }
  return fmt::format("    case \"$line $word\" in\n      {}) line=\"$line $word\" ;;\n    esac\n",
                     fmt::join(names, "|"));
}

std::string values_of(const CLI::App& command, const Shell& shell) {
  std::string text;
  for (const CLI::Option* flag : flags_of(command)) {
    if (flag->get_items_expected_max() == 0) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : names_of(*flag))
      patterns.push_back(fmt::format("\"{} {}\"", full_name(command), name));
    text += fmt::format("    {}) {}; return ;;\n", fmt::join(patterns, "|"),
                        completes_value(shell, flag->get_type_name()));
  }
  return text;
}

/// What completes a word that is not an option: a subcommand, a word of the help or a file.
std::string completes_argument(const CLI::App& command, const Shell& shell) {
  const auto below = subcommands_of(command);
  if (!below.empty()) return completes_words(shell, names_of(below));
  if (command.get_name() == "help")
    return completes_words(shell, names_of(subcommands_of(*command.get_parent())));
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() && !option->get_type_name().empty())
      return completes_value(shell, option->get_type_name());
  }
  return shell.files;
}

std::string arguments_of(const CLI::App& command, const Shell& shell, const char* typed) {
  return fmt::format(
      "    \"{}\")\n      case \"{}\" in\n        -*) {} ;;\n        *) {} ;;\n"
      "      esac ;;\n",
      full_name(command), typed, completes_words(shell, flag_names(command)),
      completes_argument(command, shell));
}

/// The cases of both shells: first the value of the option before the word, then the word.
std::string cases(const CLI::App& app, const Shell& shell, const char* typed) {
  std::string text = "  case \"$line $previous\" in\n";
  for (const CLI::App* command : all_commands(app)) text += values_of(*command, shell);
  text += "  esac\n  case \"$line\" in\n";
  for (const CLI::App* command : all_commands(app)) text += arguments_of(*command, shell, typed);
  return text + "  esac\n";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  return "# Completion of symscene for bash: symscene completion bash\n"
         "_symscene() {\n"
         "  local current=\"${COMP_WORDS[COMP_CWORD]}\" previous=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
         "  local line=symscene word\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n" +
         walk(app) + "  done\n" + cases(app, bash, "$current") +
         "}\n"
         "complete -o filenames -F _symscene symscene\n";
}

std::string zsh_completion(const CLI::App& app) {
  return "#compdef symscene\n"
         "# Completion of symscene for zsh: symscene completion zsh\n"
         "_symscene() {\n"
         "  local previous=\"${words[CURRENT-1]}\" line=symscene word\n"
         "  for word in \"${(@)words[2,CURRENT-1]}\"; do\n" +
         walk(app) + "  done\n" + cases(app, zsh, "$PREFIX") +
         "}\n"
         "if [[ \"$funcstack[1]\" == _symscene ]]; then\n"
         "  _symscene \"$@\"\n"
         "else\n"
         "  compdef _symscene symscene\n"
         "fi\n";
}

}  // namespace symscene::app
