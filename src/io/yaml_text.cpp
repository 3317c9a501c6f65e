#include "yaml_text.hpp"

#include <algorithm>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// A mantissa without a point gets one: 1e-05 becomes 1.0e-05.
std::string scalar_text(const Json& value) {
  std::string text = value.dump();
  if (!value.is_number_float()) return text;
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos)
    text.insert(exponent, ".0");
  return text;
}

class YamlText {
 public:
  std::string text;

  /// After "key:" or "-", or at the beginning.
  void add(const Json& value, std::size_t indent) {
    if (value.empty() && value.is_structured())
      text += value.is_object() ? " {}\n" : " []\n";
    else if (value.is_object())
      add_map(value, indent);
    else if (value.is_array())
      add_list(value, indent);
    else
      text += " " + scalar_text(value) + "\n";
  }

  void add_members(const Json& map, std::size_t indent, bool is_first_indented) {
    for (const auto& [key, value] : map.items()) {
      if (!is_first_indented) text.append(indent, ' ');
      is_first_indented = false;
      text += Json(key).dump() + ":";
      add(value, indent + 2);
    }
  }

 private:
  void add_map(const Json& map, std::size_t indent) {
    text += "\n";
    add_members(map, indent, false);
  }

  void add_list(const Json& list, std::size_t indent) {
    if (std::none_of(list.begin(), list.end(), [](const Json& v) { return v.is_structured(); }))
      return add_line(list);
    text += "\n";
    for (const Json& item : list) {
      text.append(indent, ' ').append("-");
      if (item.is_object() && !item.empty()) {
        text += " ";
        add_members(item, indent + 2, true);
      } else {
        add(item, indent + 2);
      }
    }
  }

  void add_line(const Json& list) {
    text += " [";
    for (std::size_t i = 0; i < list.size(); ++i)
      text += (i > 0 ? ", " : "") + scalar_text(list[i]);
    text += "]\n";
  }
};

}  // namespace

std::string format_yaml(const Json& document) {
  try {
    YamlText yaml;
    if (document.is_object() && !document.empty())
      yaml.add_members(document, 0, false);
    else
      yaml.add(document, 0);
    return std::move(yaml.text);
  } catch (const Json::exception&) {
    throw InputError("YAML to write", "names in UTF-8", "other bytes");
  }
}

}  // namespace symscene
