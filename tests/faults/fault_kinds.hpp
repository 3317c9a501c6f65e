#pragma once

#include <array>

namespace symscene::testing {

/// Calls of the C library that the library to preload makes fail, and `kill` (fault_shim.cpp).
enum class Kind { open, read, write, close, sync, rename, mkdir, allocation, kill };

inline constexpr std::array<const char*, 9> kinds = {
    "open", "read", "write", "close", "sync", "rename", "mkdir", "allocation", "kill"};

}  // namespace symscene::testing
