#include <memory>

#include "arguments.hpp"
#include "commands.hpp"
#include "manual_page.hpp"
#include "print.hpp"

namespace symscene::app {

void add_manual(CommandLine& line) {
  const auto shared = std::make_shared<SharedOptions>();
  Arguments arguments(line, "manual", "Print the manual page, in the language of man",
                      "symscene manual -o symscene.1 && man ./symscene.1");
  arguments.optional_output_file(*shared, "file to write (default: standard output)");
  arguments.run([&line, shared] { write_or_print(shared->output, manual_page(line.parser)); });
}

}  // namespace symscene::app
