#include "options_page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "option_text.hpp"

namespace symscene::app {
namespace {

constexpr const char* introduction = R"(# Options

This page lists the options that a `--config` file of each subcommand may set, with default, unit and range. For example:

```sh
symscene segment --dump-config=annotated > options.json   # all options of segment with comments, as a file to edit
echo '{"selection": {"min_score": 0.5}}' > options.json   # a file needs only the options that it changes
symscene segment scene -o result --config options.json
```
The name of an option is its path through the groups of the file: `selection.min_score`. Angles are in radians. Flags of a
subcommand (`symscene segment --help`) override the file. An unknown name, a value of another type and a value out of range
are errors that name the file and the option.

The same option can stand in other groups in another subcommand: those of the search for the table are `scene.table...` in `reconstruct`
and `stitch`, `view.scene.table...` in `segment` (of single views and clouds) and `making.scene.table...` in `dataset`.

The page is generated from the declarations of the options: `symscene options > docs/options.md`.
)";

/// A `|` would end the cell.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string range_cell(const OptionField& field) {
  if (std::holds_alternative<bool*>(field.value)) return "true or false";
  return cell(range_text(field.range));
}

std::string row(const OptionField& field) {
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", field.name, value_text(field),
                     cell(field.unit), range_cell(field), cell(field.help));
}

std::string table(const OptionFields& fields) {
  std::string text =
      "| option | default | unit | range | meaning |\n| --- | --- | --- | --- | --- |\n";
  for (const OptionField& field : fields) text += row(field);
  return text;
}

}  // namespace

std::string options_page(const std::vector<ConfigurableCommand>& commands) {
  std::string page = introduction;
  std::vector<std::string> tables;
  for (const ConfigurableCommand& command : commands) {
    page += fmt::format("\n## `symscene {}`\n", command.name);
    const std::string text = table(command.configure());
    const auto same = std::find(tables.begin(), tables.end(), text);
    const auto index = static_cast<std::size_t>(same - tables.begin());
    page += same == tables.end()
                ? text
                : fmt::format("The options of `symscene {}`.\n", commands[index].name);
    tables.push_back(text);
  }
  return page;
}

}  // namespace symscene::app
