#include "pcd.hpp"

#include <array>
#include <optional>

#include <fmt/format.h>

#include "cloud_checks.hpp"
#include "file_end.hpp"
#include "io/atomic_file.hpp"
#include "lzf.hpp"
#include "pcd_header.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

constexpr bool swaps = std::endian::native != std::endian::little;

/// The body of a PCD file: the first value of a field, for every point.
class PcdBody {
 public:
  virtual ~PcdBody() = default;
  /// As floats.
  virtual void copy(const PcdField& field, float* out) const = 0;
  /// As the 32 bits of a packed colour.
  virtual std::uint32_t bits(const PcdField& field, std::size_t point) const = 0;
};

/// binary: point after point. binary_compressed, decompressed: field after field.
class BinaryBody : public PcdBody {
 public:
  BinaryBody(std::string_view bytes, const PcdHeader& header, bool by_field)
      : bytes_(bytes), header_(header), by_field_(by_field) {}

  void copy(const PcdField& field, float* out) const override {
    copy_column({first(field), stride(field), header_.points, field.type, swaps}, out);
  }
  std::uint32_t bits(const PcdField& field, std::size_t point) const override {
    return load<std::uint32_t>(first(field) + point * stride(field));
  }

 private:
  const char* first(const PcdField& field) const {
    return bytes_.data() + (by_field_ ? field.offset * header_.points : field.offset);
  }
  std::size_t stride(const PcdField& field) const {
    return by_field_ ? field.count * size_of(field.type) : header_.point_bytes;
  }

  std::string_view bytes_;
  const PcdHeader& header_;
  bool by_field_;
};

class AsciiBody : public PcdBody {
 public:
  AsciiBody(std::string_view bytes, const PcdHeader& header, const std::string& name)
      : columns_(header.point_values) {
    values_.reserve(header.points * columns_);
    while (values_.size() < header.points * columns_) {
      const std::string_view word = next_word(bytes);
      const auto value = to_number<double>(word);
      if (word.empty()) throw InputError(name, "more values", "the end of the file");
      if (!value) throw InputError(name, "a number", in_quotes(word));
      values_.push_back(*value);
    }
    if (!next_word(bytes).empty())
      throw InputError(name, fmt::format("the values of {} points", header.points), "more");
  }

  void copy(const PcdField& field, float* out) const override {
    for (std::size_t i = field.first_column; i < values_.size(); i += columns_) {
      *out++ = static_cast<float>(values_[i]);
    }
  }
  std::uint32_t bits(const PcdField& field, std::size_t point) const override {
    const double value = values_[point * columns_ + field.first_column];
    if (is_float(field.type)) return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    const bool fits = value >= -2147483648.0 && value <= 4294967295.0;
    return fits ? static_cast<std::uint32_t>(static_cast<std::int64_t>(value)) : 0;
  }

 private:
  std::size_t columns_;
  std::vector<double> values_;
};

/// The three fields as columns, or nothing if they are not all there.
std::optional<Points> columns_of(const PcdHeader& header, const PcdBody& body,
                                 const std::array<const char*, 3>& names) {
  Points points(static_cast<Eigen::Index>(header.points), 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const PcdField* field = header.find(names[k]);
    if (field == nullptr) return std::nullopt;
    body.copy(*field, points.col(static_cast<Eigen::Index>(k)).data());
  }
  return points;
}

Colors colors_of(const PcdHeader& header, const PcdBody& body) {
  const PcdField* field = header.find("rgb");
  if (field == nullptr) field = header.find("rgba");
  if (field == nullptr || size_of(field->type) != 4) return {};
  Colors colors(static_cast<Eigen::Index>(header.points), 3);
  for (std::size_t i = 0; i < header.points; ++i) {
    const std::uint32_t packed = body.bits(*field, i);
    const auto row = static_cast<Eigen::Index>(i);
    colors(row, 0) = static_cast<std::uint8_t>(packed >> 16);
    colors(row, 1) = static_cast<std::uint8_t>(packed >> 8);
    colors(row, 2) = static_cast<std::uint8_t>(packed);
  }
  return colors;
}

PointCloud cloud_of(const PcdHeader& header, const PcdBody& body) {
  PointCloud cloud;
  cloud.positions = *columns_of(header, body, {"x", "y", "z"});
  if (auto normals = columns_of(header, body, {"normal_x", "normal_y", "normal_z"})) {
    cloud.normals = *std::move(normals);
  }
  cloud.colors = colors_of(header, body);
  return cloud;
}

void require_bytes(std::uint64_t points, std::size_t each, std::size_t available,
                   const std::string& name) {
  if (points <= available / each) return;
  throw InputError(name, fmt::format("{} points", points), fmt::format("only {} bytes", available));
}

std::string decompress(std::string_view bytes, const PcdHeader& header, const std::string& name) {
  constexpr std::size_t sizes = 8;
  if (bytes.size() < sizes) throw InputError(name, "compressed data", "the end of the file");
  const auto compressed = load<std::uint32_t>(bytes.data());
  const auto uncompressed = load<std::uint32_t>(bytes.data() + 4);
  bytes.remove_prefix(sizes);
  if (compressed > bytes.size()) {
    throw InputError(name, fmt::format("{} bytes of compressed data", compressed),
                     std::to_string(bytes.size()));
  }
  require_bytes(header.points, header.point_bytes, uncompressed, name);
  auto data = decompress_lzf(bytes.substr(0, compressed), uncompressed);
  if (!data) {
    throw InputError(name, fmt::format("LZF data that stand for {} bytes", uncompressed),
                     "other data");
  }
  return *std::move(data);
}

}  // namespace

PointCloud parse_pcd(std::string_view bytes, const std::string& name) {
  const PcdHeader header = parse_pcd_header(bytes, name);
  for (const char* axis : {"x", "y", "z"}) {
    if (header.find(axis) == nullptr) throw InputError(name, "fields x, y and z", "other fields");
  }
  const std::string_view body = bytes.substr(header.size);
  switch (header.encoding) {
    case PcdEncoding::ascii:
      require_bytes(header.points, 2 * header.point_values, body.size() + 1, name);
      return cloud_of(header, AsciiBody(body, header, name));
    case PcdEncoding::binary:
      require_bytes(header.points, header.point_bytes, body.size(), name);
      require_end(body.substr(header.points * header.point_bytes), name);
      return cloud_of(header, BinaryBody(body, header, false));
    case PcdEncoding::binary_compressed:
      break;
  }
  if (header.points == 0) return {};
  const std::string data = decompress(body, header, name);
  return cloud_of(header, BinaryBody(data, header, true));
}

std::string format_pcd(const PointCloud& cloud) {
  require_consistent(cloud, "point cloud to write");
  const bool normals = cloud.has_normals();
  const bool colors = cloud.has_colors();
  const auto line = [&](const char* key, const char* each, const char* color) {
    std::string text = key;
    for (int i = 0; i < (normals ? 6 : 3); ++i) text += each;
    return text + (colors ? color : "") + "\n";
  };
  std::string out = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z";
  out += normals ? " normal_x normal_y normal_z" : "";
  out += colors ? " rgb\n" : "\n";
  out += line("SIZE", " 4", " 4") + line("TYPE", " F", " U") + line("COUNT", " 1", " 1");
  out += fmt::format("WIDTH {0}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {0}\nDATA binary\n",
                     cloud.size());
  for (Eigen::Index i = 0; i < cloud.positions.rows(); ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) append_scalar(out, cloud.positions(i, k));
    for (Eigen::Index k = 0; normals && k < 3; ++k) append_scalar(out, cloud.normals(i, k));
    if (!colors) continue;
    const auto color = cloud.colors.row(i).cast<std::uint32_t>();
    append_scalar(out, (color[0] << 16) | (color[1] << 8) | color[2]);
  }
  return out;
}

}  // namespace symscene
