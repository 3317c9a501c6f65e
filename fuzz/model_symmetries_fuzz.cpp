#include <cstdlib>

#include "accepted.hpp"
#include "file_of.hpp"
#include "symscene/ground_truth/truth_file.hpp"

/// Any bytes are symmetries of models, finite with unit directions, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const fuzz::FileOf file(fuzz::as_bytes(data, size));
  const auto models = fuzz::accepted([&] { return read_model_symmetries(file.path()); });
  if (!models) return 0;
  for (const TrueObject& model : *models) {
    for (const TrueAxis& each : model.rotational)
      if (!each.axis.point.allFinite() || !(each.axis.direction.norm() > 0.99)) std::abort();
    for (const TruePlane& each : model.reflectional)
      if (!each.plane.point.allFinite() || !(each.plane.normal.norm() > 0.99)) std::abort();
  }
  return 0;
}
