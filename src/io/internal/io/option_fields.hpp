#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "symscene/core/error.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

/// One option of a stage, named by its path through the groups: "rotational.max_angle".
struct OptionField {
  std::string name;
  std::variant<double*, int*, bool*, std::uint64_t*, std::string*> value;
  std::string unit;
  std::string help;
  Range range;
};
using OptionFields = std::vector<OptionField>;

/// Lists the fields of an options struct (core/options.hpp) and of the groups in it.
class FieldCollector {
 public:
  FieldCollector(OptionFields& fields, std::string prefix)
      : fields_(fields), prefix_(std::move(prefix)) {}

  template <class Value>
  void operator()(const std::string& name, Value& value, const char* unit, const Range& range,
                  const char* help) {
    fields_.push_back({prefix_ + name, &value, unit, help, range});
  }
  template <class Group>
  void operator()(const std::string& name, Group& group) {
    Group::visit_fields(group, FieldCollector(fields_, prefix_ + name + "."));
  }

 private:
  OptionFields& fields_;
  std::string prefix_;
};

template <class Options>
OptionFields option_fields(Options& options) {
  OptionFields fields;
  Options::visit_fields(options, FieldCollector(fields, ""));
  return fields;
}

/// The range of the option of that name.
template <class Options>
Range range_of(Options options, const std::string& name) {
  for (const OptionField& field : option_fields(options)) {
    if (field.name == name) return field.range;
  }
  throw std::logic_error("no option " + name);
}

/// Sets the fields that a JSON file names, nested by group; // comments are allowed.
/// Throws InputError, which names the file and the option, for an unknown name, a value of another
/// type and a value out of range.
void read_config(const std::filesystem::path& file, const OptionFields& fields);

/// The same from the text of a file; `name` stands for it in messages.
void parse_config(const std::string& text, const std::string& name, const OptionFields& fields);

/// Runs `validate`. An InputError from it names `file` too, if there is one.
void validate_with(const std::filesystem::path& file, const std::function<void()>& validate);

/// Sets `options` from `file`, if it names one, then from the flags of the command line, and
/// validates them. Returns their fields. Throws InputError as read_config() and validate() do.
template <class Options>
OptionFields configure_options(
    Options& options, const std::filesystem::path& file,
    const std::function<void()>& apply_flags = [] {}) {
  OptionFields fields = option_fields(options);
  if (!file.empty()) read_config(file, fields);
  apply_flags();
  validate_with(file, [&] { options.validate(); });
  return fields;
}

/// The values of all fields as indented JSON in groups, which read_config() reads back.
std::string option_values(const OptionFields& fields);

/// The values of the fields that differ from those of equal name in `defaults`, as JSON in groups.
std::string changed_options(const OptionFields& fields, const OptionFields& defaults);

}  // namespace symscene
