#include "ply_header.hpp"

#include <algorithm>
#include <utility>

#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

using Words = std::vector<std::string_view>;

std::optional<ScalarType> scalar_type(std::string_view word) {
  static constexpr std::pair<std::string_view, ScalarType> spellings[] = {
      {"char", ScalarType::int8},      {"int8", ScalarType::int8},
      {"uchar", ScalarType::uint8},    {"uint8", ScalarType::uint8},
      {"short", ScalarType::int16},    {"int16", ScalarType::int16},
      {"ushort", ScalarType::uint16},  {"uint16", ScalarType::uint16},
      {"int", ScalarType::int32},      {"int32", ScalarType::int32},
      {"uint", ScalarType::uint32},    {"uint32", ScalarType::uint32},
      {"float", ScalarType::float32},  {"float32", ScalarType::float32},
      {"double", ScalarType::float64}, {"float64", ScalarType::float64}};
  for (const auto& [spelling, type] : spellings) {
    if (word == spelling) return type;
  }
  return std::nullopt;
}

std::optional<PlyEncoding> parse_format(const Words& words) {
  if (words.size() != 3 || words[2] != "1.0") return std::nullopt;
  if (words[1] == "ascii") return PlyEncoding::ascii;
  if (words[1] == "binary_little_endian") return PlyEncoding::little_endian;
  if (words[1] == "binary_big_endian") return PlyEncoding::big_endian;
  return std::nullopt;
}

std::optional<PlyElement> parse_element(const Words& words) {
  if (words.size() != 3) return std::nullopt;
  const auto count = to_number<std::uint64_t>(words[2]);
  if (!count) return std::nullopt;
  return PlyElement{std::string(words[1]), *count, {}};
}

std::optional<PlyProperty> parse_property(const Words& words) {
  const bool list = words.size() == 5 && words[1] == "list";
  if (!list && words.size() != 3) return std::nullopt;
  const auto type = scalar_type(words[list ? 3 : 1]);
  if (!type) return std::nullopt;
  PlyProperty property{std::string(words.back()), *type, std::nullopt};
  if (!list) return property;
  property.length_type = scalar_type(words[2]);
  if (!property.length_type || is_float(*property.length_type)) return std::nullopt;
  return property;
}

/// Parses one line into `header`. Returns what was expected if the line is wrong.
const char* add_line(const Words& words, PlyHeader& header, bool& has_format) {
  if (words[0] == "format") {
    const auto encoding = parse_format(words);
    if (!encoding) return "format ascii, binary_little_endian or binary_big_endian 1.0";
    header.encoding = *encoding;
    has_format = true;
  } else if (words[0] == "element") {
    auto element = parse_element(words);
    if (!element) return "element NAME COUNT";
    header.elements.push_back(*std::move(element));
  } else if (words[0] == "property") {
    auto property = parse_property(words);
    if (!property || header.elements.empty()) return "property [list TYPE] TYPE NAME";
    header.elements.back().properties.push_back(*std::move(property));
  } else if (words[0] != "comment" && words[0] != "obj_info") {
    return "a line of a PLY header";
  }
  return nullptr;
}

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& p) { return p.name == property; });
  if (found == properties.end()) return std::nullopt;
  return static_cast<std::size_t>(found - properties.begin());
}

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.is_list(); });
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement& e) { return e.name == element; });
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) {
  std::string_view rest = bytes;
  if (next_line(rest) != "ply") {
    throw InputError(name, "a PLY file, which begins with a line \"ply\"",
                     in_quotes(bytes.substr(0, bytes.find('\n'))));
  }
  PlyHeader header;
  bool has_format = false;
  while (true) {
    const auto line = next_line(rest);
    if (!line) throw InputError(name, "a line end_header", "the end of the file");
    const Words words = words_of(*line);
    if (words.empty()) continue;
    if (words[0] == "end_header") break;
    const char* expected = add_line(words, header, has_format);
    if (expected != nullptr) throw InputError(name, expected, in_quotes(*line));
  }
  if (!has_format) throw InputError(name, "a format line in the PLY header", "none");
  header.size = bytes.size() - rest.size();
  return header;
}

}  // namespace symscene
