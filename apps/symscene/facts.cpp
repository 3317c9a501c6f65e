#include "facts.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace symscene::app {

std::string Facts::table() const {
  std::size_t width = 0;
  for (const Row& row : rows_) width = std::max(width, row.label.size());
  std::string text;
  for (const Row& row : rows_) {
    text += fmt::format("{}{:<{}}  {}", text.empty() ? "" : "\n", row.label, width, row.text);
  }
  return text;
}

}  // namespace symscene::app
