#include "image_files.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Removes the digits from the front of `text`; returns them without leading zeros.
std::string_view take_digits(std::string_view& text) {
  const auto* const end = std::find_if_not(text.begin(), text.end(), is_digit);
  std::string_view taken = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(taken.size());
  while (taken.size() > 1 && taken.front() == '0') taken.remove_prefix(1);
  return taken;
}

}  // namespace

std::vector<fs::path> files_ending(const fs::path& dir,
                                   std::initializer_list<const char*> endings) {
  std::vector<fs::path> files;
  if (!fs::is_directory(dir)) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(dir)) {
    const std::string name = entry.path().filename().string();
    const bool ends = std::any_of(endings.begin(), endings.end(),
                                  [&](const char* ending) { return name.ends_with(ending); });
    if (ends && name.front() != '.' && entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().native(), b.filename().native());
  });
  return files;
}

std::optional<std::uint64_t> digits(std::string_view word) {
  if (!std::all_of(word.begin(), word.end(), is_digit)) return std::nullopt;
  return to_number<std::uint64_t>(word);
}

bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a;
  const std::string_view whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view number_a = take_digits(a);
      const std::string_view number_b = take_digits(b);
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
      if (number_a != number_b) return number_a < number_b;
    } else {
      if (a.front() != b.front()) return a.front() < b.front();
      a.remove_prefix(1), b.remove_prefix(1);
    }
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;
}

std::vector<double> parse_times(std::string_view text, const std::string& name) {
  std::vector<double> times;
  for (std::size_t line = 1; !text.empty(); ++line) {
    std::string_view rest = without_comment(take_line(text));
    const std::string_view word = next_word(rest);
    if (word.empty()) continue;
    const auto time = to_number<double>(word);
    if (time && std::isfinite(*time) && next_word(rest).empty() &&
        (times.empty() || *time >= times.back())) {
      times.push_back(*time);
    } else {
      throw InputError(fmt::format("{}: line {}", name, line), "a time, not before the last",
                       in_quotes(word));
    }
  }
  return times;
}

fs::path listed_file(const fs::path& dir, std::string_view listed, const std::string& where) {
  const fs::path relative = fs::path(listed).lexically_normal();
  if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") {
    throw InputError(where, "the path of an image below the folder", in_quotes(listed));
  }
  return dir / relative;
}

}  // namespace symscene
