#include <string>

#include "accepted.hpp"
#include "symscene/evaluation/report.hpp"

/// Any bytes are the report of an earlier evaluation, which can be compared with itself, or
/// refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(symscene::fuzz::as_bytes(data, size));
  symscene::fuzz::accepted([&] { return symscene::report_difference(text, text, "fuzz"); });
  return 0;
}
