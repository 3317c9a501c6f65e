#include "commands.hpp"
#include "options_page.hpp"
#include "print.hpp"

namespace symscene::app {

void add_options(CommandLine& line) {
  Arguments arguments(line, "options",
                      "Print the options of every subcommand's --config file as Markdown",
                      "symscene options > options.md");
  arguments.run([&line] { print_output(options_page(line.configurable)); });
}

}  // namespace symscene::app
