#pragma once

#include <string_view>

namespace symscene {

/// viewer/dist/page.html, embedded when the library is built (cmake/SymsceneViewer.cmake).
std::string_view page_template();

/// viewer/dist/review.html, the same.
std::string_view review_template();

/// viewer/dist/run.html, the same.
std::string_view run_template();

/// viewer/dist/live.html, the same.
std::string_view live_template();

}  // namespace symscene
