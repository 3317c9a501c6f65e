#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symscene {

/// The frame rate of layouts that number their frames and do not time them. [1/s]
constexpr double default_rate = 30.0;

/// The files of a folder whose names end in one of `endings` (".png"), numbers in names by value;
/// none if it is no folder.
std::vector<std::filesystem::path> files_ending(const std::filesystem::path& dir,
                                                std::initializer_list<const char*> endings);

/// The whole number that a word is written as, digits only.
std::optional<std::uint64_t> digits(std::string_view word);

/// Whether `a` comes before `b` where runs of digits count as numbers: "a9" before "a10".
bool natural_less(std::string_view a, std::string_view b);

/// Rising times, one a line. [s] `name` stands for the file in messages.
std::vector<double> parse_times(std::string_view text, const std::string& name);

/// Where the file that a list in `dir` names lies. Throws InputError, with `where`, if that is not
/// below `dir`.
std::filesystem::path listed_file(const std::filesystem::path& dir, std::string_view listed,
                                  const std::string& where);

}  // namespace symscene
