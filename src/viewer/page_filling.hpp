#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace symscene {

/// JSON that may stand in a script element.
std::string script_json(const nlohmann::json& json);

/// The page with its placeholders replaced by a title, which is escaped, and by script_json().
std::string fill_page(std::string_view page, std::string_view title, std::string_view payload);

}  // namespace symscene
