#pragma once

#include <string>

#include "evaluation/report_text.hpp"

namespace symscene {

/// Number of colours of methods; colour k is that of the class "ck".
constexpr std::size_t report_colors = 8;

/// The beginning of a report's page, with the style of all of its parts, up to its body. The title
/// is escaped. The page is well-formed XML and ends with report_end.
std::string report_head(const std::string& title);
inline constexpr const char* report_end = "</body>\n</html>\n";

/// A heading with a paragraph. `text` is markup.
std::string report_section(const char* title, const char* text);

/// A table, whose cells are escaped. Classes: "l1" or "l2" for the columns that are flush left,
/// "last" for the last one too, "total" for a row of sums at the end.
std::string report_table(const TextTable& table, const char* classes);

}  // namespace symscene
