#include "symscene/viewer/live_page.hpp"

#include "page_filling.hpp"
#include "page_template.hpp"

namespace symscene {

std::string render_live_page(const std::string& title) {
  return fill_page(live_template(), title, script_json({{"title", title}}));
}

}  // namespace symscene
