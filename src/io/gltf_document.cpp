#include "gltf_document.hpp"

#include <limits>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

/// The two parts of a GLB file, or the JSON alone.
struct GltfChunks {
  std::string_view json;
  std::string_view binary;
};

std::string_view take_chunk(std::string_view& rest, const char* kind, const std::string& name) {
  constexpr std::size_t chunk_header = 8;
  if (rest.size() >= chunk_header && rest.substr(4, 4) == std::string_view(kind, 4)) {
    const auto length = load<std::uint32_t>(rest.data());
    rest.remove_prefix(chunk_header);
    if (length <= rest.size()) {
      const std::string_view chunk = rest.substr(0, length);
      rest.remove_prefix(length);
      return chunk;
    }
  }
  throw InputError(name, fmt::format("a GLB file with a whole chunk {:.3}", kind), "none");
}

GltfChunks split_chunks(std::string_view bytes, const std::string& name) {
  constexpr std::size_t header = 12;
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  if (bytes.size() < header || load<std::uint32_t>(bytes.data() + 4) != 2) {
    throw InputError(name, "glTF of version 2", "another version");
  }
  bytes.remove_prefix(header);
  GltfChunks chunks;
  chunks.json = take_chunk(bytes, "JSON", name);
  if (!bytes.empty()) chunks.binary = take_chunk(bytes, "BIN\0", name);
  return chunks;
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::string decode_base64(std::string_view text, const JsonCursor& uri) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  unsigned bits = 0;
  unsigned bit_count = 0;
  for (const char c : text) {
    const int digit = base64_digit(c);
    if (digit < 0) uri.fail("base64");
    bits = (bits << 6) | static_cast<unsigned>(digit);
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes += static_cast<char>((bits >> bit_count) & 255U);
  }
  return bytes;
}

std::string read_uri(const JsonCursor& uri, const ReadBeside& read_beside) {
  const std::string text = uri.string();
  if (text.starts_with("data:")) {
    constexpr std::string_view marker = ";base64,";
    const std::size_t begin = text.find(marker);
    if (begin == std::string::npos) uri.fail("base64");
    return decode_base64(std::string_view(text).substr(begin + marker.size()), uri);
  }
  const bool beside = !text.empty() && text.front() != '/' &&
                      text.find("..") == std::string::npos && text.find(':') == std::string::npos;
  if (!beside) uri.fail("a file in the same folder");
  return read_beside(text);
}

std::size_t count_or(const JsonCursor& object, const char* key, std::size_t otherwise) {
  const auto member = object.find(key);
  return member ? member->count() : otherwise;
}

ScalarType component_type(const JsonCursor& type) {
  switch (type.count()) {
    case 5120:
      return ScalarType::int8;
    case 5121:
      return ScalarType::uint8;
    case 5122:
      return ScalarType::int16;
    case 5123:
      return ScalarType::uint16;
    case 5125:
      return ScalarType::uint32;
    case 5126:
      return ScalarType::float32;
    default:
      type.fail("a component type of glTF");
  }
}

std::size_t component_count(const JsonCursor& type) {
  const std::string text = type.string();
  if (text == "SCALAR") return 1;
  if (text == "VEC2") return 2;
  if (text == "VEC3") return 3;
  if (text == "VEC4") return 4;
  type.fail("SCALAR, VEC2, VEC3 or VEC4");
}

}  // namespace

double GltfAccessor::value(std::size_t element, std::size_t component) const {
  const char* at = first + element * stride + component * size_of(type);
  return load_as_double(type, at, std::endian::native != std::endian::little);
}

double GltfAccessor::fraction(std::size_t element, std::size_t component) const {
  if (is_float(type)) return value(element, component);
  const double largest = with_scalar_type(type, [](auto zero) -> double {
    return static_cast<double>(std::numeric_limits<decltype(zero)>::max());
  });
  return value(element, component) / largest;
}

GltfDocument::GltfDocument(std::string_view bytes, std::string name, const ReadBeside& read_beside)
    : name_(std::move(name)), file_size_(bytes.size()) {
  const GltfChunks chunks = split_chunks(bytes, name_);
  json_ = parse_json(chunks.json, name_);
  require_known_extensions();
  const auto buffers = root().find("buffers");
  if (!buffers) return;
  for (const JsonCursor& buffer : buffers->items()) {
    const auto uri = buffer.find("uri");
    if (!uri && !buffers_.empty()) buffer.fail("a buffer with a uri");
    buffers_.push_back(uri ? read_uri(*uri, read_beside) : std::string(chunks.binary));
  }
}

std::size_t GltfDocument::size() const {
  std::size_t size = file_size_;
  for (const std::string& buffer : buffers_) size += buffer.size();
  return size;
}

void GltfDocument::require_known_extensions() const {
  const auto required = root().find("extensionsRequired");
  if (!required) return;
  for (const JsonCursor& extension : required->items()) {
    const std::string text = extension.string();
    const bool harmless = text.starts_with("KHR_materials_") || text.starts_with("KHR_texture_") ||
                          text.starts_with("KHR_lights_");
    if (!harmless) extension.fail("plain glTF, without compression");
  }
}

/// The bytes of the buffer view of an accessor; `stride` becomes the distance of its elements.
std::string_view GltfDocument::view(const JsonCursor& accessor, std::size_t& stride) const {
  const JsonCursor view = root().at("bufferViews").at(accessor.at("bufferView").count());
  const std::size_t buffer = view.at("buffer").count();
  if (buffer >= buffers_.size()) view.at("buffer").fail("the index of a buffer");
  const std::string_view bytes = buffers_[buffer];
  const std::size_t offset = count_or(view, "byteOffset", 0);
  const std::size_t length = view.at("byteLength").count();
  if (offset > bytes.size() || length > bytes.size() - offset) {
    view.fail(fmt::format("a part of the {} bytes of its buffer", bytes.size()));
  }
  stride = count_or(view, "byteStride", stride);
  return bytes.substr(offset, length);
}

GltfAccessor GltfDocument::accessor(const JsonCursor& index) const {
  const JsonCursor json = root().at("accessors").at(index.count());
  if (json.find("sparse")) json.fail("an accessor that is not sparse");
  GltfAccessor accessor{};
  accessor.type = component_type(json.at("componentType"));
  accessor.components = component_count(json.at("type"));
  accessor.count = json.at("count").count();
  const std::size_t element = accessor.components * size_of(accessor.type);
  accessor.stride = element;
  std::string_view bytes = view(json, accessor.stride);
  const std::size_t offset = count_or(json, "byteOffset", 0);
  const bool fits = accessor.stride >= element && offset <= bytes.size() &&
                    (accessor.count == 0 ||
                     (element <= bytes.size() - offset &&
                      accessor.count - 1 <= (bytes.size() - offset - element) / accessor.stride));
  if (!fits) json.fail(fmt::format("elements inside the {} bytes of its view", bytes.size()));
  accessor.first = bytes.data() + offset;
  return accessor;
}

}  // namespace symscene
