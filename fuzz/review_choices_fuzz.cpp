#include <cstdlib>

#include "accepted.hpp"
#include "io/review_choices.hpp"

/// Any bytes are the choices of a review, with finite places, unit directions and orders of an
/// axis, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const auto models =
      fuzz::accepted([&] { return parse_review_choices(fuzz::as_bytes(data, size), "fuzz"); });
  if (!models) return 0;
  for (const auto& [name, choices] : *models) {
    for (const ReviewChoice& each : choices) {
      if (!each.point.allFinite() || !(each.direction.norm() > 0.99)) std::abort();
      if (each.order && (each.kind != "axis" || *each.order < 0 || *each.order == 1)) std::abort();
    }
  }
  return 0;
}
