#pragma once

#include <string_view>

namespace symscene {

/// viewer/dist/page.html, embedded when the library is built (cmake/SymsceneViewer.cmake).
std::string_view page_template();

}  // namespace symscene
