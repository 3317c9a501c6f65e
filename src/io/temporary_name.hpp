#pragma once

#include <filesystem>

namespace symscene {

/// A name in the same folder that no other thread or process uses: ".NAME.tmp-PID-N".
std::filesystem::path temporary_beside(const std::filesystem::path& path);

}  // namespace symscene
