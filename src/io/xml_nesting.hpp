#pragma once

#include <string_view>

namespace symscene {

/// The greatest number of elements of an XML text inside one another. Unclosed elements count.
int nesting_depth(std::string_view xml);

}  // namespace symscene
