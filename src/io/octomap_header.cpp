#include "octomap_header.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {

OctomapHeader parse_octomap_header(std::string_view& rest, std::string_view first_line,
                                   const std::string& kind, const std::string& name) {
  const std::string_view begin = rest.substr(0, rest.find('\n'));
  if (next_line(rest) != first_line) throw InputError(name, kind, in_quotes(begin));
  OctomapHeader header;
  std::optional<std::uint64_t> size;
  bool has_id = false;
  while (true) {
    const auto line = next_line(rest);
    if (!line) throw InputError(name, "a line \"data\"", "the end of the file");
    const auto words = words_of(*line);
    if (words.empty() || words[0].starts_with('#')) continue;
    if (words[0] == "data") break;
    const std::string_view value = words.size() > 1 ? words[1] : "";
    if (words[0] == "id" && value != "OcTree")
      throw InputError(name, "id OcTree", in_quotes(*line));
    has_id = has_id || words[0] == "id";
    if (words[0] == "size") size = to_number<std::uint64_t>(value);
    if (words[0] == "res") header.resolution = to_number<double>(value).value_or(0.0);
  }
  if (!has_id) throw InputError(name, "a line id OcTree", "none");
  if (!size) throw InputError(name, "a line size N", "none");
  if (!(header.resolution > 0.0 && std::isfinite(header.resolution))) {
    throw InputError(name, "a positive resolution after res", fmt::format("{}", header.resolution));
  }
  header.size = *size;
  return header;
}

std::string format_octomap_header(const OctomapHeader& header, std::string_view first_line) {
  return fmt::format("{}\nid OcTree\nsize {}\nres {}\ndata\n", first_line, header.size,
                     header.resolution);
}

void require_nodes(const OctomapHeader& header, std::uint64_t nodes, const std::string& name) {
  if (nodes == header.size) return;
  throw InputError(name, fmt::format("{} nodes, as its header declares", header.size),
                   std::to_string(nodes));
}

}  // namespace symscene
