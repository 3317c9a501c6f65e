#include "io/option_fields.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/nearest_name.hpp"
#include "io/atomic_file.hpp"

namespace symscene {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

std::string describe_value(const json& value) {
  if (value.is_object()) return "a group in braces";
  if (value.is_array()) return "a list";
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::vector<std::string> names_and_groups(const OptionFields& fields) {
  std::vector<std::string> names;
  for (const OptionField& field : fields) {
    names.push_back(field.name);
    for (std::size_t dot = field.name.find('.'); dot != std::string::npos;
         dot = field.name.find('.', dot + 1)) {
      names.push_back(field.name.substr(0, dot));
    }
  }
  return names;
}

/// Sets fields from JSON values; its errors name the file.
class Assignment {
 public:
  Assignment(std::string file, const OptionFields& fields)
      : file_(std::move(file)), fields_(fields) {}

  void assign_group(const json& group, const std::string& prefix) const {
    for (const auto& [key, value] : group.items()) assign(prefix + key, value);
  }

 private:
  void assign(const std::string& name, const json& value) const {
    const auto field = std::find_if(fields_.begin(), fields_.end(),
                                    [&](const OptionField& f) { return f.name == name; });
    if (field != fields_.end()) {
      std::visit([&](auto* target) { set(*target, *field, value); }, field->value);
    } else if (!is_group(name)) {
      throw InputError(file_, "only options that --dump-config lists", unknown(name));
    } else if (!value.is_object()) {
      refuse("a group of options in braces", name, value);
    } else {
      assign_group(value, name + ".");
    }
  }

  bool is_group(const std::string& name) const {
    return std::any_of(fields_.begin(), fields_.end(),
                       [&](const OptionField& f) { return f.name.starts_with(name + "."); });
  }

  [[noreturn]] void refuse(const std::string& expected, const std::string& name,
                           const json& value) const {
    throw InputError(file_, fmt::format("{} for \"{}\"", expected, name), describe_value(value));
  }

  void require_range(const OptionField& field, double number, const json& value) const {
    if (field.range.contains(number)) return;
    const std::string unit = field.unit.empty() ? "" : " " + field.unit;
    refuse(fmt::format("a number {}{}", to_string(field.range), unit), field.name, value);
  }

  void set(double& target, const OptionField& field, const json& value) const {
    if (!value.is_number()) refuse("a number", field.name, value);
    const auto number = value.get<double>();
    require_range(field, number, value);
    target = number;
  }
  void set(bool& target, const OptionField& field, const json& value) const {
    if (!value.is_boolean()) refuse("true or false", field.name, value);
    target = value.get<bool>();
  }
  void set(std::uint64_t& target, const OptionField& field, const json& value) const {
    if (!value.is_number_unsigned()) refuse("a whole number from 0", field.name, value);
    require_range(field, value.get<double>(), value);
    target = value.get<std::uint64_t>();
  }
  void set(int& target, const OptionField& field, const json& value) const {
    constexpr double low = std::numeric_limits<int>::min();
    constexpr double high = std::numeric_limits<int>::max();
    const bool whole = value.is_number_integer();
    if (!whole || value.get<double>() < low || value.get<double>() > high)
      refuse("a whole number", field.name, value);
    require_range(field, value.get<double>(), value);
    target = value.get<int>();
  }
  void set(std::string& target, const OptionField& field, const json& value) const {
    if (!value.is_string()) refuse("a text in quotes", field.name, value);
    target = value.get<std::string>();
  }

  /// The name, with the most similar option or group if one is similar.
  std::string unknown(const std::string& name) const {
    return with_nearest_name(name, names_and_groups(fields_));
  }

  std::string file_;
  const OptionFields& fields_;
};

json parse_config_text(const std::string& text, const std::string& name) {
  try {
    return json::parse(text, nullptr, true, true);
  } catch (const json::parse_error& error) {
    const std::size_t at = std::min<std::size_t>(error.byte, text.size());
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
    throw InputError(name, "JSON",
                     fmt::format("a mistake on line {}", 1 + std::count(text.begin(), end, '\n')));
  } catch (const json::exception&) {
    throw InputError(name, "JSON", "a number out of range");
  }
}

ordered_json option_value(const OptionField& field) {
  return std::visit([](const auto* value) { return ordered_json(*value); }, field.value);
}

void add_option(const OptionField& field, ordered_json& values) {
  std::string pointer = "/" + field.name;
  std::replace(pointer.begin(), pointer.end(), '.', '/');
  values[ordered_json::json_pointer(pointer)] = option_value(field);
}

}  // namespace

void parse_config(const std::string& text, const std::string& name, const OptionFields& fields) {
  const json values = parse_config_text(text, name);
  if (!values.is_object()) throw InputError(name, "options in braces", describe_value(values));
  Assignment(name, fields).assign_group(values, "");
}

void read_config(const std::filesystem::path& file, const OptionFields& fields) {
  parse_config(read_file(file), file.string(), fields);
}

void validate_with(const std::filesystem::path& file, const std::function<void()>& validate) {
  try {
    validate();
  } catch (const InputError& error) {
    if (file.empty()) throw;
    throw InputError(fmt::format("{} (with the options of {})", error.where(), file.string()),
                     error.expected(), error.found());
  }
}

std::string option_values(const OptionFields& fields) {
  ordered_json values = ordered_json::object();
  for (const OptionField& field : fields) add_option(field, values);
  return values.dump(2);
}

std::string changed_options(const OptionFields& fields, const OptionFields& defaults) {
  ordered_json values = ordered_json::object();
  for (const OptionField& field : fields) {
    const auto is_same = [&](const OptionField& other) {
      return other.name == field.name && option_value(other) == option_value(field);
    };
    if (std::none_of(defaults.begin(), defaults.end(), is_same)) add_option(field, values);
  }
  return values.dump();
}

}  // namespace symscene
