#pragma once

#include <string>
#include <string_view>

namespace symscene {

/// A text with the characters that mean something in HTML replaced, for elements and attributes.
std::string escape_html(std::string_view text);

}  // namespace symscene
