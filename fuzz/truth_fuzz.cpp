#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/ground_truth/truth_file.hpp"

/// Any bytes are a ground truth whose text stays the same when read and written again, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto truth = fuzz::accepted([&] { return parse_truth(bytes, "fuzz", 100); });
  if (!truth) return 0;
  const std::string text = format_truth(*truth);
  if (format_truth(parse_truth(text, "again", 100)) != text) std::abort();
  return 0;
}
