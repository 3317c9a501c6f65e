#pragma once

#include <string>
#include <vector>

namespace symscene::app {

/// The texts between commas; one more than there are commas.
inline std::vector<std::string> comma_separated(const std::string& text) {
  std::vector<std::string> items{""};
  for (const char c : text) {
    if (c == ',')
      items.emplace_back();
    else
      items.back() += c;
  }
  return items;
}

}  // namespace symscene::app
