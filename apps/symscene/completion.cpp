#include <memory>

#include "arguments.hpp"
#include "commands.hpp"
#include "print.hpp"
#include "shell_completion.hpp"

namespace symscene::app {

void add_completion(CommandLine& line) {
  struct State {
    SharedOptions shared;
    std::string shell;
  };
  const auto state = std::make_shared<State>();
  Arguments arguments(line, "completion", "Print a script by which a shell completes the command",
                      "source <(symscene completion bash)\n"
                      "  symscene completion zsh -o _symscene");
  arguments.word(state->shell, "SHELL", {"bash", "zsh"}, "shell");
  arguments.optional_output_file(state->shared, "file to write (default: standard output)");
  arguments.run([&line, state] {
    write_or_print(state->shared.output, state->shell == "bash" ? bash_completion(line.parser)
                                                                : zsh_completion(line.parser));
  });
}

}  // namespace symscene::app
