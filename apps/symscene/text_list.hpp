#pragma once

#include <string>
#include <vector>

namespace symscene::app {

/// The texts between separators; one more than there are separators.
inline std::vector<std::string> separated(const std::string& text, char separator = ',') {
  std::vector<std::string> items{""};
  for (const char c : text) {
    if (c == separator)
      items.emplace_back();
    else
      items.back() += c;
  }
  return items;
}

}  // namespace symscene::app
