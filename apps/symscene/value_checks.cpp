#include "value_checks.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/nearest_name.hpp"
#include "core/number_in.hpp"

namespace symscene::app {
namespace {

std::string sentence(const std::string& expected, const std::string& text) {
  return fmt::format("expected {}, found {}", expected, text.empty() ? "none" : text);
}

}  // namespace

std::string check_whole_number(const std::string& text, const Range& range) {
  constexpr auto most = static_cast<double>(std::numeric_limits<std::uint64_t>::max());
  // Without a range of its own the parser would wrap negative and large numbers around.
  const auto number = number_in<std::uint64_t>(text);
  if (number && range.contains(static_cast<double>(*number))) return "";
  if (range.high < most) return sentence(fmt::format("a whole number {}", to_string(range)), text);
  return sentence(fmt::format("a whole number from {} to {}", range.low,
                              std::numeric_limits<std::uint64_t>::max()),
                  text);
}

std::string check_choice(const std::string& text, const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), text) != choices.end()) return "";
  return sentence(fmt::format("one of {}", fmt::join(choices, ", ")),
                  with_nearest_name(text, choices));
}

std::string check_ending(const std::string& name, const std::vector<std::string>& endings) {
  const std::string ending = std::filesystem::path(name).extension().string();
  if (ending.empty() || endings.empty() || std::ranges::count(endings, ending) > 0) return "";
  return sentence(fmt::format("a name that ends in {}", fmt::join(endings, " or ")), name);
}

std::string check_depth_scale(const std::string& text) {
  constexpr Range range = between(0.1, 1e6);
  const auto number = number_in<double>(text);
  if (number && range.contains(*number)) return "";
  return sentence("a number in [0.1, 1000000]", text);
}

}  // namespace symscene::app
