#include "io/json_cursor.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "text.hpp"
#include "unit_vectors.hpp"

namespace symscene {
namespace {

/// A value for a message.
std::string describe(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("an array of {}", value.size());
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  return value.dump();
}

/// Refuses objects with very many members while parsing, as an ordered object compares every new
/// key with all previous ones, and members that are given twice.
class MemberCheck {
 public:
  explicit MemberCheck(std::string name) : name_(std::move(name)) {}

  bool operator()(int /*depth*/, Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) members_.emplace_back();
    if (event == Json::parse_event_t::object_end) members_.pop_back();
    if (event == Json::parse_event_t::key) add(parsed.get_ref<const std::string&>());
    return true;
  }

 private:
  static constexpr std::size_t limit = 1000;

  void add(const std::string& key) {
    std::set<std::string>& members = members_.back();
    if (!members.insert(key).second)
      throw InputError(name_, "each member of a JSON object once", in_quotes(key) + " twice");
    if (members.size() > limit)
      throw InputError(name_, fmt::format("JSON objects of at most {} members", limit), "more");
  }

  std::string name_;
  std::vector<std::set<std::string>> members_;  ///< of each open object
};

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
  try {
    return Json::parse(text, MemberCheck(name));
  } catch (const Json::parse_error& error) {
    throw InputError(name, "JSON", fmt::format("a mistake at byte {}", error.byte));
  } catch (const Json::exception&) {
    throw InputError(name, "JSON", "a number out of range");
  }
}

void JsonCursor::fail(const std::string& expected) const {
  throw InputError(where(), expected, describe(*value_));
}

JsonCursor JsonCursor::at(const char* key) const {
  if (const auto found = member(key)) return *found;
  throw InputError(where(), fmt::format("a member \"{}\"", key), "none");
}

std::optional<JsonCursor> JsonCursor::find(const char* key) const {
  const auto found = member(key);
  return found && !found->value_->is_null() ? found : std::nullopt;
}

std::optional<JsonCursor> JsonCursor::member(const char* key) const {
  if (!value_->is_object()) fail("an object");
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return JsonCursor(*found, *name_, path_.empty() ? key : path_ + "." + key);
}

JsonCursor JsonCursor::at(std::size_t i) const {
  if (i < size()) return item(i);
  fail(fmt::format("an array of more than {}", i));
}

std::size_t JsonCursor::size() const {
  if (!value_->is_array()) fail("an array");
  return value_->size();
}

JsonCursor JsonCursor::item(std::size_t i) const {
  return {(*value_)[i], *name_, fmt::format("{}[{}]", path_, i)};
}

std::vector<JsonCursor> JsonCursor::items(std::optional<std::size_t> count) const {
  if (!value_->is_array()) fail("an array");
  if (count && value_->size() != *count) fail(fmt::format("an array of {}", *count));
  std::vector<JsonCursor> result;
  for (std::size_t i = 0; i < value_->size(); ++i) result.push_back(item(i));
  return result;
}

std::vector<std::pair<std::string, JsonCursor>> JsonCursor::members() const {
  if (!value_->is_object()) fail("an object");
  std::vector<std::pair<std::string, JsonCursor>> result;
  for (const auto& [key, value] : value_->items()) {
    const std::string prefix = path_.empty() ? "" : path_ + ".";
    result.emplace_back(key, JsonCursor(value, *name_, prefix + in_quotes(key)));
  }
  return result;
}

double JsonCursor::number() const {
  if (!value_->is_number()) fail("a number");
  return value_->get<double>();
}

double JsonCursor::number_or_nan() const {
  return value_->is_null() ? std::numeric_limits<double>::quiet_NaN() : number();
}

std::size_t JsonCursor::count() const {
  if (!value_->is_number_unsigned()) fail("a whole number, not negative");
  return value_->get<std::size_t>();
}

bool JsonCursor::boolean() const {
  if (!value_->is_boolean()) fail("true or false");
  return value_->get<bool>();
}

bool JsonCursor::is_string() const { return value_->is_string(); }

std::string JsonCursor::string() const {
  if (!is_string()) fail("a string");
  return value_->get<std::string>();
}

Eigen::Vector3d JsonCursor::vector3() const {
  const auto numbers = items(3);
  return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
}

Eigen::Vector3d JsonCursor::direction() const { return unit_vector(vector3(), where()); }

Plane JsonCursor::plane() const {
  const auto numbers = items(4);
  return normalized_plane(
      {numbers[0].number(), numbers[1].number(), numbers[2].number(), numbers[3].number()},
      where());
}

PointIndices JsonCursor::indices(std::optional<Index> size) const {
  if (!value_->is_array()) fail("an array of indices");
  constexpr Index largest = std::numeric_limits<Index>::max();
  const std::uint64_t end = size.value_or(largest);
  PointIndices result;
  result.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) {
    const Json& value = (*value_)[i];
    if (!value.is_number_unsigned()) item(i).fail("the index of a point");
    const auto index = value.get<std::uint64_t>();
    if (index >= end) item(i).fail(fmt::format("an index below {}, the size of the cloud", end));
    if (!result.empty() && index <= result.back()) item(i).fail("ascending indices");
    result.push_back(static_cast<Index>(index));
  }
  return result;
}

Json to_json(double value, const char* what) {
  if (!std::isfinite(value)) throw InputError(what, "finite numbers", fmt::format("{}", value));
  return value;
}

Json to_json(const Eigen::Vector3d& vector, const char* what) {
  return Json::array(
      {to_json(vector.x(), what), to_json(vector.y(), what), to_json(vector.z(), what)});
}

Json to_json(const Plane& plane, const char* what) {
  Json json = to_json(plane.normal, what);
  json.push_back(to_json(plane.offset, what));
  return json;
}

std::string format_json(const Json& document) {
  try {
    return document.dump() + "\n";
  } catch (const Json::exception&) {
    throw InputError("JSON to write", "names in UTF-8", "other bytes");
  }
}

}  // namespace symscene
