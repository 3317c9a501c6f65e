#include "pcd_header.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "symscene/core/types.hpp"
#include "text.hpp"

namespace symscene {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t largest_point = std::size_t{1} << 20;  ///< bytes

std::optional<ScalarType> scalar_type(std::string_view type, std::string_view size) {
  const std::string spelling = std::string(type) + std::string(size);
  static const std::map<std::string, ScalarType> types = {
      {"I1", ScalarType::int8},    {"U1", ScalarType::uint8},  {"I2", ScalarType::int16},
      {"U2", ScalarType::uint16},  {"I4", ScalarType::int32},  {"U4", ScalarType::uint32},
      {"I8", ScalarType::int64},   {"U8", ScalarType::uint64}, {"F4", ScalarType::float32},
      {"F8", ScalarType::float64},
  };
  const auto found = types.find(spelling);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

/// The lines of a header by their first word, up to and with DATA.
class PcdLines {
 public:
  PcdLines(std::string_view& rest, std::string name) : name_(std::move(name)) {
    while (!lines_.contains("DATA")) {
      const auto line = next_line(rest);
      if (!line) throw InputError(name_, "a line DATA in the PCD header", "the end of the file");
      Words words = words_of(*line);
      if (words.empty() || words[0].starts_with('#')) continue;
      if (!known(words[0])) throw InputError(name_, "a line of a PCD header", in_quotes(*line));
      if (!lines_.emplace(words[0], Words(words.begin() + 1, words.end())).second)
        throw InputError(name_, "each line of a PCD header once", in_quotes(words[0]) + " twice");
    }
  }

  bool has(std::string_view key) const { return lines_.contains(key); }

  const Words& words(const char* key, std::size_t count) const {
    const auto found = lines_.find(key);
    if (found == lines_.end()) throw InputError(name_, fmt::format("a line {}", key), "none");
    if (count == 0 || found->second.size() == count) return found->second;
    throw InputError(name_, fmt::format("{} values after {}", count, key),
                     std::to_string(found->second.size()));
  }

  std::uint64_t number(const char* key) const {
    const std::string_view word = words(key, 1).front();
    const auto value = to_number<std::uint32_t>(word);
    if (!value)
      throw InputError(name_, fmt::format("a number below 2^32 after {}", key), in_quotes(word));
    return *value;
  }

 private:
  static bool known(std::string_view key) {
    static constexpr std::string_view keys[] = {"VERSION", "FIELDS", "COLUMNS",  "SIZE",
                                                "TYPE",    "COUNT",  "WIDTH",    "HEIGHT",
                                                "POINTS",  "DATA",   "VIEWPOINT"};
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
  }

  std::string name_;
  std::map<std::string_view, Words> lines_;
};

std::size_t parse_count(std::string_view word, const std::string& name) {
  const auto count = to_number<std::size_t>(word);
  if (count && *count >= 1 && *count <= largest_point) return *count;
  throw InputError(name, "a COUNT of at least 1", in_quotes(word));
}

void parse_fields(const PcdLines& lines, const std::string& name, PcdHeader& header) {
  const Words& names = lines.words(lines.has("COLUMNS") ? "COLUMNS" : "FIELDS", 0);
  const Words& sizes = lines.words("SIZE", names.size());
  const Words& types = lines.words("TYPE", names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto type = scalar_type(types[i], sizes[i]);
    if (!type) {
      throw InputError(name, "TYPE I or U of SIZE 1, 2, 4, 8 or F of 4, 8",
                       fmt::format("{} of {}", in_quotes(types[i]), in_quotes(sizes[i])));
    }
    PcdField field{std::string(names[i]), *type, 1, header.point_bytes, header.point_values};
    if (lines.has("COUNT")) field.count = parse_count(lines.words("COUNT", names.size())[i], name);
    header.point_bytes += field.count * size_of(field.type);
    header.point_values += field.count;
    header.fields.push_back(std::move(field));
    if (header.point_bytes > largest_point) {
      throw InputError(name, "points of at most 1 MiB",
                       fmt::format("{} bytes", header.point_bytes));
    }
  }
}

void require_known_version(const PcdLines& lines, const std::string& name) {
  if (!lines.has("VERSION")) return;
  const std::string_view word = lines.words("VERSION", 1).front();
  for (const std::string_view known : {"0.5", ".5", "0.6", ".6", "0.7", ".7"}) {
    if (word == known) return;
  }
  throw InputError(name, "a PCD file of version 0.5, 0.6 or 0.7", in_quotes(word));
}

std::uint64_t parse_points(const PcdLines& lines, const std::string& name) {
  const bool has_size = lines.has("WIDTH") && lines.has("HEIGHT");
  const std::uint64_t points =
      lines.has("POINTS") ? lines.number("POINTS") : lines.number("WIDTH") * lines.number("HEIGHT");
  if (has_size && points != lines.number("WIDTH") * lines.number("HEIGHT"))
    throw InputError(name, "as many POINTS as WIDTH times HEIGHT", std::to_string(points));
  if (points <= std::numeric_limits<Index>::max()) return points;
  throw InputError(name, "fewer than 2^32 points", std::to_string(points));
}

PcdEncoding parse_encoding(const PcdLines& lines, const std::string& name) {
  const std::string_view word = lines.words("DATA", 1).front();
  if (word == "ascii") return PcdEncoding::ascii;
  if (word == "binary") return PcdEncoding::binary;
  if (word == "binary_compressed") return PcdEncoding::binary_compressed;
  throw InputError(name, "DATA ascii, binary or binary_compressed", in_quotes(word));
}

/// The position in VIEWPOINT tx ty tz qw qx qy qz; the origin where the file does not give it.
Eigen::Vector3d parse_viewpoint(const PcdLines& lines, const std::string& name) {
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
  if (!lines.has("VIEWPOINT")) return viewpoint;
  const Words& words = lines.words("VIEWPOINT", 7);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::string_view word = words[static_cast<std::size_t>(axis)];
    const auto value = to_number<double>(word);
    if (!value || !std::isfinite(*value))
      throw InputError(name, "finite numbers after VIEWPOINT", in_quotes(word));
    viewpoint[axis] = *value;
  }
  return viewpoint;
}

}  // namespace

const PcdField* PcdHeader::find(std::string_view field) const {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const PcdField& f) { return f.name == field; });
  return found == fields.end() ? nullptr : &*found;
}

PcdHeader parse_pcd_header(std::string_view bytes, const std::string& name) {
  std::string_view rest = bytes;
  const PcdLines lines(rest, name);
  require_known_version(lines, name);
  PcdHeader header;
  parse_fields(lines, name, header);
  header.points = parse_points(lines, name);
  header.encoding = parse_encoding(lines, name);
  header.viewpoint = parse_viewpoint(lines, name);
  header.size = bytes.size() - rest.size();
  return header;
}

}  // namespace symscene
