#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/number_in.hpp"

namespace symscene {

inline bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Removes the next word, ended by white space, from the front of `text`; empty at the end.
inline std::string_view next_word(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_space(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !is_space(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

/// Removes the next line from the front of `text` and returns it without its end; nothing if no
/// line ends.
inline std::optional<std::string_view> next_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// As next_line(), but the end of `text` ends a line too.
inline std::string_view take_line(std::string_view& text) {
  if (const auto line = next_line(text)) return *line;
  return std::exchange(text, {});
}

/// The line up to the first #.
inline std::string_view without_comment(std::string_view line) {
  return line.substr(0, line.find('#'));
}

inline std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    words.push_back(word);
  }
  return words;
}

/// Parses all of `word` as a number, which may begin with a plus.
template <class Number>
std::optional<Number> to_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  return number_in<Number>(word);
}

/// Text from a file for a message: quoted, shortened, printable.
inline std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 40)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > 40 ? "...\"" : "\"");
}

}  // namespace symscene
