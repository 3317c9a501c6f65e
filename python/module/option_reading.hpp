#pragma once

#include <string>

#include "io/option_fields.hpp"

namespace symscene::python {

/// Sets options from JSON as --config does, `options` in place of the file's name, without
/// validating them.
template <class Options>
void set_options(Options& options, const std::string& json) {
  parse_config(json, "options", option_fields(options));
}

/// Valid options from JSON. Throws InputError as --config does.
template <class Options>
Options options_from(const std::string& json) {
  Options options;
  set_options(options, json);
  options.validate();
  return options;
}

}  // namespace symscene::python
