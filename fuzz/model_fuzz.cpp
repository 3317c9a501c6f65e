#include <cstdlib>
#include <string>
#include <vector>

#include "accepted.hpp"
#include "symscene/core/tree_model.hpp"

/// Any bytes are a model that estimates a probability and whose text stays the same when read and
/// written again, or are refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto model = fuzz::accepted([&] { return parse_tree_model(bytes, "fuzz"); });
  if (!model) return 0;
  for (const double value : {-1e300, 0.0, 1e300}) {
    const std::vector<double> values(model->features().size(), value);
    const double probability = model->probability(values);
    if (!(probability >= 0.0 && probability <= 1.0)) std::abort();
  }
  const std::string text = format_tree_model(*model);
  if (format_tree_model(parse_tree_model(text, "again")) != text) std::abort();
  return 0;
}
