#pragma once

#include <nlohmann/json.hpp>

#include "symscene/viewer/page.hpp"

namespace symscene {

/// Views as the page reads them; null without. Throws InputError if a pose, a gain or the size of
/// the image is not finite.
nlohmann::json view_payload(const std::optional<PageViews>& views);

}  // namespace symscene
