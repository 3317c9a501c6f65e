#include "symscene/viewer/page.hpp"

#include <string_view>

#include "page_payload.hpp"
#include "page_template.hpp"
#include "payload.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::string_view title_placeholder = "@@SYMSCENE_TITLE@@";
constexpr std::string_view payload_placeholder = "\"@@SYMSCENE_PAYLOAD@@\"";

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

void require_direction(const char* option, const Eigen::Vector3d& direction) {
  if (!direction.allFinite() || direction.norm() < 1e-9) {
    throw InputError(option, "a direction", "a vector that is zero or not finite");
  }
}

}  // namespace

void PageOptions::validate() const {
  if (up) require_direction("up", *up);
  if (table) require_direction("table.normal", table->normal);
}

std::string page_payload(const SegmentationResult& result, const PageOptions& options) {
  const std::string json =
      make_payload(result, options).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  // "</script" and "<!--" would end the script element, even inside a JSON string.
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string render_page(const SegmentationResult& result, const PageOptions& options) {
  const std::string_view page = page_template();
  const std::size_t title = page.find(title_placeholder);
  const std::size_t payload = page.find(payload_placeholder, title);
  std::string html(page.substr(0, title));
  html += escape_html(options.title);
  html += page.substr(title + title_placeholder.size(), payload - title - title_placeholder.size());
  html += page_payload(result, options);
  html += page.substr(payload + payload_placeholder.size());
  return html;
}

}  // namespace symscene
