#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/json_cursor.hpp"
#include "mesh_formats.hpp"
#include "scalar.hpp"

namespace symscene {

/// `count` elements of `components` numbers inside a buffer.
struct GltfAccessor {
  const char* first;
  std::size_t stride;
  std::size_t count;
  std::size_t components;
  ScalarType type;

  double value(std::size_t element, std::size_t component) const;
  /// As value(), but integers are fractions of their largest value.
  double fraction(std::size_t element, std::size_t component) const;
};

/// A glTF 2.0 file: its JSON and its buffers.
class GltfDocument {
 public:
  /// Throws InputError if `bytes` are not a glTF file or require an extension that affects the
  /// geometry.
  GltfDocument(std::string_view bytes, std::string name, const ReadBeside& read_beside);

  JsonCursor root() const { return {json_, name_}; }

  /// Bytes of the file and of its buffers.
  std::size_t size() const;

  /// The accessor with this index. Throws InputError if it exceeds its buffer.
  GltfAccessor accessor(const JsonCursor& index) const;

 private:
  void require_known_extensions() const;
  std::string_view view(const JsonCursor& accessor, std::size_t& stride) const;

  std::string name_;
  std::size_t file_size_;
  Json json_;
  std::vector<std::string> buffers_;
};

}  // namespace symscene
