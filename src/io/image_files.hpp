#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symscene {

/// The assumed frame rate of layouts whose frames have numbers but no times. [1/s]
constexpr double default_rate = 30.0;

/// The files of a folder whose names end in one of `endings` (".png"), in the order of
/// natural_less(); empty if it is not a folder.
std::vector<std::filesystem::path> files_ending(const std::filesystem::path& dir,
                                                std::initializer_list<const char*> endings);

/// The value of a word of digits; nothing for other words.
std::optional<std::uint64_t> digits(std::string_view word);

/// Whether `a` is before `b` if runs of digits are compared as numbers: "a9" before "a10".
bool natural_less(std::string_view a, std::string_view b);

/// Parses ascending times [s], one per line. `name` is the name of the file in messages.
std::vector<double> parse_times(std::string_view text, const std::string& name);

/// The path of a file that a list in `dir` contains. Throws InputError, with `where`, if it is not
/// below `dir`.
std::filesystem::path listed_file(const std::filesystem::path& dir, std::string_view listed,
                                  const std::string& where);

}  // namespace symscene
