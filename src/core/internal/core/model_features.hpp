#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/core/error.hpp"
#include "symscene/core/tree_model.hpp"

namespace symscene {

/// The number of fields that Features::visit_fields visits.
template <class Features>
constexpr std::size_t field_count = [] {
  const Features features{};
  std::size_t count = 0;
  Features::visit_fields(features, [&count](const char*, double) { ++count; });
  return count;
}();

/// The values of feature structs, one struct after the other, in the order of their fields.
template <class... Features>
std::array<double, (field_count<Features> + ...)> values_of(const Features&... features) {
  std::array<double, (field_count<Features> + ...)> values{};
  std::size_t next = 0;
  const auto append = [&](const char*, double value) { values.at(next++) = value; };
  (Features::visit_fields(features, append), ...);
  return values;
}

/// Their names in the same order, as a model must list them.
template <class... Features>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  const auto append = [&](const char* name, double) { names.emplace_back(name); };
  const auto append_all = [&](const auto& features) { features.visit_fields(features, append); };
  (append_all(Features{}), ...);
  return names;
}

/// A model whose text is embedded from models/NAME.txt (cmake/SymsceneEmbed.cmake). Throws
/// InputError unless it was fitted to these features.
template <class... Features>
TreeModel embedded_model(const std::string& name, std::string_view text) {
  const std::string file = "models/" + name + ".txt";
  TreeModel model = parse_tree_model(text, file);
  model.require(file, name, names_of<Features...>());
  return model;
}

/// Throws InputError unless `choice` is the embedded model or one of this name and these features.
template <class... Features>
void check_choice(const ModelChoice& choice, const std::string& name) {
  if (choice.model) {
    choice.model->require(choice.file.empty() ? name : choice.file, name, names_of<Features...>());
  } else if (!choice.file.empty()) {
    throw InputError(choice.file, "a model that was read from this file", "only its path");
  }
}

inline const TreeModel& chosen_model(const ModelChoice& choice, const TreeModel& embedded) {
  return choice.model ? *choice.model : embedded;
}

}  // namespace symscene
