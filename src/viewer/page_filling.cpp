#include "page_filling.hpp"

#include "viewer/html_text.hpp"

namespace symscene {
namespace {

constexpr std::string_view title_placeholder = "@@SYMSCENE_TITLE@@";
constexpr std::string_view payload_placeholder = "\"@@SYMSCENE_PAYLOAD@@\"";

}  // namespace

std::string script_json(const nlohmann::json& json) {
  const std::string text = json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  // "</script" and "<!--" would end the script element, even inside a JSON string.
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string fill_page(std::string_view page, std::string_view title, std::string_view payload) {
  const std::size_t title_at = page.find(title_placeholder);
  const std::size_t payload_at = page.find(payload_placeholder, title_at);
  const std::size_t between = title_at + title_placeholder.size();
  std::string html(page.substr(0, title_at));
  html += escape_html(title);
  html += page.substr(between, payload_at - between);
  html += payload;
  html += page.substr(payload_at + payload_placeholder.size());
  return html;
}

}  // namespace symscene
