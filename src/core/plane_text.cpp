#include "core/plane_text.hpp"

#include <fmt/format.h>

namespace symscene {

std::string plane_text(const Plane& plane) {
  return fmt::format("{:.4f},{:.4f},{:.4f},{:.4f}", plane.normal.x(), plane.normal.y(),
                     plane.normal.z(), plane.offset);
}

}  // namespace symscene
