#include "yaml.hpp"

#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_YAML
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_YAML

Json parse_yaml(std::string_view /*text*/, const std::string& name) {
  throw InputError(name, "a build with a reader of YAML (install libyaml-cpp-dev and build again)",
                   "one without");
}

#else

namespace {

constexpr int max_depth = 32;
constexpr int max_nodes = 100000;

Json scalar(const std::string& text) {
  if (text == "true") return true;
  if (text == "false") return false;
  if (text == "null" || text == "~" || text.empty()) return nullptr;
  const char* first = text.data();
  const char* last = first + text.size();
  const char* digits = *first == '+' ? first + 1 : first;
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits, last, value);
  // Other than numbers, texts such as "nan" and "inf" stay texts.
  if (error == std::errc() && end == last && std::isfinite(value)) return value;
  return text;
}

class Conversion {
 public:
  explicit Conversion(const std::string& name) : name_(name) {}

  Json convert(const YAML::Node& node, int depth) {
    if (depth > max_depth || ++nodes_ > max_nodes)
      throw InputError(name_, fmt::format("at most {} levels and {} values", max_depth, max_nodes),
                       "more");
    if (node.IsScalar()) return node.Tag() == "!" ? Json(node.Scalar()) : scalar(node.Scalar());
    if (node.IsSequence()) return sequence(node, depth);
    if (node.IsMap()) return map(node, depth);
    return nullptr;
  }

 private:
  Json sequence(const YAML::Node& node, int depth) {
    Json list = Json::array();
    for (const YAML::Node& item : node) list.push_back(convert(item, depth + 1));
    return list;
  }

  Json map(const YAML::Node& node, int depth) {
    Json object = Json::object();
    for (const auto& item : node) {
      const int line = item.first.Mark().line + 1;
      if (!item.first.IsScalar())
        throw InputError(name_, "names as keys", fmt::format("a list or map on line {}", line));
      const std::string& key = item.first.Scalar();
      if (object.contains(key))
        throw InputError(name_, "each key once", fmt::format("\"{}\" again on line {}", key, line));
      object[key] = convert(item.second, depth + 1);
    }
    return object;
  }

  const std::string& name_;
  int nodes_ = 0;
};

}  // namespace

Json parse_yaml(std::string_view text, const std::string& name) {
  try {
    return Conversion(name).convert(YAML::Load(std::string(text)), 0);
  } catch (const YAML::Exception& error) {
    throw InputError(name, "YAML",
                     fmt::format("a mistake on line {}: {}", error.mark.line + 1, error.msg));
  }
}

#endif

}  // namespace symscene
