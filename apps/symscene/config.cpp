#include "config.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "option_text.hpp"

namespace symscene::app {
namespace {

using nlohmann::ordered_json;

std::string comment(const OptionField& field) {
  const std::string kind = kind_text(field);
  return kind.empty() ? field.help : fmt::format("[{}] {}", kind, field.help);
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

}  // namespace

std::string format_config(const OptionFields& fields, bool annotated) {
  if (!annotated) return option_values(fields) + "\n";
  constexpr std::size_t column = 44;
  std::string text;
  auto field = fields.begin();
  for (const std::string& line : split_lines(option_values(fields))) {
    const bool is_value = !line.ends_with('{') && !line.ends_with('}') && !line.ends_with("},");
    text +=
        is_value ? fmt::format("{:<{}}  // {}\n", line, column, comment(*field++)) : line + "\n";
  }
  return text;
}

std::string describe_run(const std::string& command, const OptionFields& fields,
                         const std::string& frames, const std::string& sensor) {
  ordered_json run = {{"version", 1},
                      {"symscene", SYMSCENE_VERSION},
                      {"command", command},
                      {"options", ordered_json::parse(option_values(fields))}};
  if (!frames.empty()) run["frames"] = ordered_json::parse(frames);
  if (!sensor.empty()) run["sensor"] = ordered_json::parse(sensor);
  return run.dump(2) + "\n";
}

}  // namespace symscene::app
