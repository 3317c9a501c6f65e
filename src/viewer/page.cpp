#include "symscene/viewer/page.hpp"

#include "page_filling.hpp"
#include "page_payload.hpp"
#include "page_template.hpp"
#include "payload.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

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
  return script_json(make_payload(result, options));
}

std::string render_page(const SegmentationResult& result, const PageOptions& options) {
  return fill_page(page_template(), options.title, page_payload(result, options));
}

}  // namespace symscene
