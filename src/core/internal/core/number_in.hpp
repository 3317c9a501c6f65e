#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace symscene {

/// All of `text` as a number; none if it is not one or out of the type's range.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || after != end) return std::nullopt;
  return number;
}

}  // namespace symscene
