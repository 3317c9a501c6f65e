#pragma once

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {

/// Checks JSON against the schemas in docs/: the part of draft 2020-12 that they use. A keyword
/// that it does not know is an error, so that nothing passes unchecked.
class JsonSchema {
 public:
  using Json = nlohmann::json;

  explicit JsonSchema(const std::string& file) : file_(file) {}

  /// The first violation with its path, or nothing.
  std::string violation(const Json& value) { return check({file_, root(file_)}, value, "$"); }

 private:
  struct Place {
    std::string file;
    const Json& schema;
  };
  using Check = std::string (JsonSchema::*)(const Place&, const Json&, const Json&,
                                            const std::string&);

  const Json& root(const std::string& file) {
    const auto known = files_.find(file);
    if (known != files_.end()) return known->second;
    const std::string text = contents(fs::path(SYMSCENE_SOURCE_DIR) / "docs" / file);
    return files_[file] = Json::parse(text);
  }

  /// "FILE#/POINTER", without FILE in the same file.
  Place referenced(const Place& place, const std::string& reference) {
    const std::size_t hash = reference.find('#');
    const std::string named = reference.substr(0, hash);
    const std::string file = named.empty() ? place.file : named;
    const std::string pointer = hash == std::string::npos ? "" : reference.substr(hash + 1);
    return {file, root(file).at(Json::json_pointer(pointer))};
  }

  std::string check(const Place& place, const Json& value, const std::string& path) {
    for (const auto& [keyword, argument] : place.schema.items()) {
      const auto found = checks().find(keyword);
      if (found == checks().end()) throw std::logic_error("unknown keyword " + keyword);
      if (found->second == nullptr) continue;
      const std::string violation = (this->*found->second)(place, argument, value, path);
      if (!violation.empty()) return violation;
    }
    return "";
  }

  static std::string unless(bool holds, const char* keyword, const Json& argument,
                            const Json& value, const std::string& path) {
    if (holds) return "";
    return path + ": " + keyword + " " + argument.dump().substr(0, 80) + ", found " +
           value.dump().substr(0, 80);
  }

  static bool is_of_type(const Json& value, const std::string& name) {
    static const std::map<std::string, bool (Json::*)() const noexcept> types{
        {"object", &Json::is_object}, {"array", &Json::is_array},
        {"string", &Json::is_string}, {"integer", &Json::is_number_integer},
        {"number", &Json::is_number}, {"boolean", &Json::is_boolean},
        {"null", &Json::is_null}};
    return (value.*types.at(name))();
  }
  std::string type(const Place&, const Json& argument, const Json& value, const std::string& path) {
    const Json names = argument.is_array() ? argument : Json::array({argument});
    const bool holds = std::any_of(names.begin(), names.end(),
                                   [&](const Json& name) { return is_of_type(value, name); });
    return unless(holds, "type", argument, value, path);
  }
  std::string constant(const Place&, const Json& argument, const Json& value,
                       const std::string& path) {
    return unless(value == argument, "const", argument, value, path);
  }
  std::string one_value_of(const Place&, const Json& argument, const Json& value,
                           const std::string& path) {
    const bool holds = std::find(argument.begin(), argument.end(), value) != argument.end();
    return unless(holds, "enum", argument, value, path);
  }
  std::string minimum(const Place&, const Json& argument, const Json& value,
                      const std::string& path) {
    return unless(!value.is_number() || value >= argument, "minimum", argument, value, path);
  }
  std::string maximum(const Place&, const Json& argument, const Json& value,
                      const std::string& path) {
    return unless(!value.is_number() || value <= argument, "maximum", argument, value, path);
  }
  std::string least_items(const Place&, const Json& argument, const Json& value,
                          const std::string& path) {
    return unless(!value.is_array() || value.size() >= argument, "minItems", argument, value, path);
  }
  std::string most_items(const Place&, const Json& argument, const Json& value,
                         const std::string& path) {
    return unless(!value.is_array() || value.size() <= argument, "maxItems", argument, value, path);
  }
  std::string unique_items(const Place&, const Json& argument, const Json& value,
                           const std::string& path) {
    const bool holds =
        !value.is_array() || std::set<Json>(value.begin(), value.end()).size() == value.size();
    return unless(holds || argument == false, "uniqueItems", argument, value, path);
  }
  std::string pattern(const Place&, const Json& argument, const Json& value,
                      const std::string& path) {
    const bool holds =
        !value.is_string() ||
        std::regex_search(value.get<std::string>(), std::regex(argument.get<std::string>()));
    return unless(holds, "pattern", argument, value, path);
  }
  std::string required(const Place&, const Json& argument, const Json& value,
                       const std::string& path) {
    for (const Json& name : argument) {
      if (value.is_object() && !value.contains(name.get<std::string>()))
        return path + ": required " + name.dump();
    }
    return "";
  }
  std::string properties(const Place& place, const Json& argument, const Json& value,
                         const std::string& path) {
    if (!value.is_object()) return "";
    for (const auto& [name, schema] : argument.items()) {
      if (!value.contains(name)) continue;
      const std::string violation = check({place.file, schema}, value.at(name), path + "." + name);
      if (!violation.empty()) return violation;
    }
    return "";
  }
  std::string additional(const Place& place, const Json& argument, const Json& value,
                         const std::string& path) {
    if (!value.is_object()) return "";
    const Json known = place.schema.value("properties", Json::object());
    for (const auto& [name, member] : value.items()) {
      if (known.contains(name)) continue;
      if (argument.is_boolean()) {
        if (argument == false) return path + ": no member \"" + name + "\"";
        continue;
      }
      const std::string violation = check({place.file, argument}, member, path + "." + name);
      if (!violation.empty()) return violation;
    }
    return "";
  }
  std::string names(const Place& place, const Json& argument, const Json& value,
                    const std::string& path) {
    if (!value.is_object()) return "";
    for (const auto& [name, member] : value.items()) {
      const std::string violation = check({place.file, argument}, name, path + " name");
      if (!violation.empty()) return violation;
    }
    return "";
  }
  std::string items(const Place& place, const Json& argument, const Json& value,
                    const std::string& path) {
    if (!value.is_array()) return "";
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string violation =
          check({place.file, argument}, value[i], path + "[" + std::to_string(i) + "]");
      if (!violation.empty()) return violation;
    }
    return "";
  }
  std::string reference(const Place& place, const Json& argument, const Json& value,
                        const std::string& path) {
    return check(referenced(place, argument), value, path);
  }
  std::string all_of(const Place& place, const Json& argument, const Json& value,
                     const std::string& path) {
    for (const Json& schema : argument) {
      const std::string violation = check({place.file, schema}, value, path);
      if (!violation.empty()) return violation;
    }
    return "";
  }
  std::string one_of(const Place& place, const Json& argument, const Json& value,
                     const std::string& path) {
    std::size_t holding = 0;
    for (const Json& schema : argument) {
      if (check({place.file, schema}, value, path).empty()) ++holding;
    }
    return unless(holding == 1, "oneOf", argument, value, path);
  }
  std::string negation(const Place& place, const Json& argument, const Json& value,
                       const std::string& path) {
    return unless(!check({place.file, argument}, value, path).empty(), "not", argument, value,
                  path);
  }

  /// The keywords; those that say nothing about the value have no check.
  static const std::map<std::string, Check>& checks() {
    static const std::map<std::string, Check> table{
        {"$schema", nullptr},
        {"$defs", nullptr},
        {"title", nullptr},
        {"description", nullptr},
        {"type", &JsonSchema::type},
        {"const", &JsonSchema::constant},
        {"enum", &JsonSchema::one_value_of},
        {"minimum", &JsonSchema::minimum},
        {"maximum", &JsonSchema::maximum},
        {"minItems", &JsonSchema::least_items},
        {"maxItems", &JsonSchema::most_items},
        {"uniqueItems", &JsonSchema::unique_items},
        {"pattern", &JsonSchema::pattern},
        {"required", &JsonSchema::required},
        {"properties", &JsonSchema::properties},
        {"additionalProperties", &JsonSchema::additional},
        {"propertyNames", &JsonSchema::names},
        {"items", &JsonSchema::items},
        {"$ref", &JsonSchema::reference},
        {"allOf", &JsonSchema::all_of},
        {"oneOf", &JsonSchema::one_of},
        {"not", &JsonSchema::negation}};
    return table;
  }

  std::string file_;
  std::map<std::string, Json> files_;
};

}  // namespace symscene::testing
