#include "folder_swap.hpp"

#include <fcntl.h>
#include <cstdio>

#include <system_error>

#include "symscene/core/error.hpp"
#include "temporary_name.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

/// Exchanges two folders in one step, if the file system supports it. Returns whether it did.
bool exchange(const fs::path& a, const fs::path& b) {
#ifdef RENAME_EXCHANGE
  return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
  static_cast<void>(a), static_cast<void>(b);
  return false;
#endif
}

void put_back(const fs::path& old, const fs::path& target) {
  std::error_code error;
  fs::rename(old, target, error);
  if (error) {
    throw InputError(target.string(), "a folder that can be renamed",
                     error.message() + "; the old folder is " + old.string());
  }
}

}  // namespace

void swap_folders(const fs::path& staging, const fs::path& target) {
  if (exchange(staging, target)) return;
  const fs::path old = set_aside_beside(target);
  fs::rename(target, old);
  std::error_code error;
  fs::rename(staging, target, error);
  if (error) {
    put_back(old, target);
    throw fs::filesystem_error("rename", staging, target, error);
  }
  // Under the name of staging, as what is partly removed must not be given its name back.
  fs::rename(old, staging, error);
  if (error) fs::remove_all(old, error);
}

}  // namespace symscene
