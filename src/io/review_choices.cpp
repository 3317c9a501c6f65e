#include "io/review_choices.hpp"

#include "io/json_cursor.hpp"

namespace symscene {
namespace {

/// As the option that bounds the orders that are searched.
constexpr std::size_t greatest_order = 24;

/// The string of a member, which must be one of three.
std::string one_of(const JsonCursor& value, const char* a, const char* b, const char* c) {
  const std::string word = value.string();
  if (word != a && word != b && word != c) value.fail(std::string(a) + ", " + b + " or " + c);
  return word;
}

std::optional<int> order_of(const JsonCursor& symmetry) {
  const std::optional<JsonCursor> order = symmetry.find("order");
  if (!order) return std::nullopt;
  if (order->is_string()) {
    if (order->string() != "continuous") order->fail("a number or continuous");
    return ReviewChoice::continuous;
  }
  const std::size_t number = order->count();
  if (number < 2 || number > greatest_order) order->fail("2 to 24 or continuous");
  return static_cast<int>(number);
}

ReviewChoice choice_of(const JsonCursor& symmetry) {
  const std::string kind = one_of(symmetry.at("kind"), "plane", "axis", "sphere");
  return {kind, symmetry.at("point").vector3(), symmetry.at("direction").direction(),
          one_of(symmetry.at("choice"), "accepted", "rejected", "open"),
          kind == "axis" ? order_of(symmetry) : std::nullopt};
}

}  // namespace

ReviewChoicesByModel parse_review_choices(std::string_view text, const std::string& name) {
  const Json document = parse_json(text, name);
  const JsonCursor root(document, name);
  if (root.at("version").count() != 1) root.at("version").fail("1");
  ReviewChoicesByModel models;
  for (const JsonCursor& model : root.at("models").items()) {
    const auto [entry, is_new] = models.try_emplace(model.at("name").string());
    if (!is_new) model.at("name").fail("a model once");
    for (const JsonCursor& symmetry : model.at("symmetries").items())
      entry->second.push_back(choice_of(symmetry));
  }
  return models;
}

}  // namespace symscene
