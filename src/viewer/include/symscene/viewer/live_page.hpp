#pragma once

#include <string>

namespace symscene {

/// The page of a live scene: HTML that gets its updates from the server that it comes from
/// (docs/formats.md, *Live updates*).
std::string render_live_page(const std::string& title);

}  // namespace symscene
