#pragma once

#include <filesystem>

namespace symscene {

/// Replaces the folder `target` by `staging`, in one step where the file system can exchange two
/// names. Elsewhere `target` is set aside first (set_aside_beside()); if the process ends before
/// `staging` has its name, remove_stale_staging() gives it its name back. Afterwards `staging` is
/// the old folder, or does not exist. Throws std::filesystem::filesystem_error if a folder cannot
/// be renamed, with `target` unchanged, and InputError if then the old one cannot get its name back
/// either, with the place where it is.
void swap_folders(const std::filesystem::path& staging, const std::filesystem::path& target);

}  // namespace symscene
