#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string_view>

namespace symscene {

/// A name in the same folder that no other thread or process uses: ".NAME.tmp-HOST-PID-N". HOST
/// tells machines and containers apart, whose processes have the same numbers.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Such a name for what stands at `path` itself while something else takes its place.
std::filesystem::path set_aside_beside(const std::filesystem::path& path);

/// Whether a name that has a writer_of() is one of set_aside_beside().
bool is_set_aside(std::string_view name);

/// The process of this machine that writes, or wrote, `target` to a temporary file of this name;
/// none if it is not one.
std::optional<pid_t> writer_of(std::string_view name, std::string_view target);

}  // namespace symscene
