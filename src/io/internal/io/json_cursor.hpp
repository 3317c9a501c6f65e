#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "symscene/core/geometry.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

using Json = nlohmann::ordered_json;

/// Throws InputError if `text` is not JSON.
Json parse_json(std::string_view text, const std::string& name);

/// A value in a JSON document with its path, so that every message names file and path. All members
/// throw InputError if the value is not of the type that they return.
class JsonCursor {
 public:
  /// The root of a document. Both must outlive the cursor and all cursors obtained from it.
  JsonCursor(const Json& document, const std::string& name) : value_(&document), name_(&name) {}

  /// A required member, and an optional one, which may also be null.
  JsonCursor at(const char* key) const;
  std::optional<JsonCursor> find(const char* key) const;

  /// A required item of an array.
  JsonCursor at(std::size_t i) const;
  std::size_t size() const;  ///< of an array

  /// The items of an array, `count` of them if given.
  std::vector<JsonCursor> items(std::optional<std::size_t> count = std::nullopt) const;
  /// The names and values of an object, in the file's order.
  std::vector<std::pair<std::string, JsonCursor>> members() const;

  double number() const;  ///< finite
  double number_or_nan() const;
  std::size_t count() const;
  bool boolean() const;
  bool is_string() const;
  std::string string() const;
  Eigen::Vector3d vector3() const;
  Eigen::Vector3d direction() const;  ///< scaled to unit length
  Plane plane() const;                ///< [a, b, c, d], scaled to a unit normal
  /// Ascending indices below `size` if that is given.
  PointIndices indices(std::optional<Index> size) const;

  std::string where() const { return *name_ + (path_.empty() ? "" : ": " + path_); }
  [[noreturn]] void fail(const std::string& expected) const;

 private:
  JsonCursor(const Json& value, const std::string& name, std::string path)
      : value_(&value), name_(&name), path_(std::move(path)) {}
  JsonCursor item(std::size_t i) const;
  std::optional<JsonCursor> member(const char* key) const;

  const Json* value_;
  const std::string* name_;
  std::string path_;
};

/// A number or vector as JSON. Throws InputError, with `what` as the file, if it is not finite.
Json to_json(double value, const char* what);
Json to_json(const Eigen::Vector3d& vector, const char* what);
Json to_json(const Plane& plane, const char* what);  ///< [a, b, c, d]

/// The document on one line. Throws InputError if a string is not UTF-8.
std::string format_json(const Json& document);

}  // namespace symscene
