#include "xml_nesting.hpp"

#include <algorithm>

namespace symscene {
namespace {

/// The end of a tag that begins at `begin`; `>` in quotes does not end it.
std::size_t end_of_tag(std::string_view xml, std::size_t begin) {
  char quote = 0;
  for (std::size_t i = begin; i < xml.size(); ++i) {
    const char c = xml[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i;
    }
  }
  return xml.size();
}

std::size_t after_comment(std::string_view xml, std::size_t begin) {
  const std::size_t end = xml.find("-->", begin);
  return end == std::string_view::npos ? xml.size() : end + 3;
}

}  // namespace

int nesting_depth(std::string_view xml) {
  int depth = 0;
  int greatest = 0;
  for (std::size_t i = xml.find('<'); i < xml.size(); i = xml.find('<', i)) {
    if (xml.substr(i).starts_with("<!--")) {
      i = after_comment(xml, i);
      continue;
    }
    const std::size_t end = end_of_tag(xml, i + 1);
    const char first = i + 1 < xml.size() ? xml[i + 1] : '>';
    if (first == '/') {
      depth = std::max(0, depth - 1);
    } else if (first != '!' && first != '?' && xml[end - 1] != '/') {
      greatest = std::max(greatest, ++depth);
    }
    i = end;
  }
  return greatest;
}

}  // namespace symscene
