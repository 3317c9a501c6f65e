#pragma once

#include <filesystem>
#include <memory>

#include "symscene/io/sequence.hpp"

namespace symscene {

using SequencePointer = std::unique_ptr<DepthSequence>;

// Whether a path looks like a layout, and the sequence that it is then. docs/formats.md describes
// them.
bool is_own_layout(const std::filesystem::path& path);
SequencePointer open_own_layout(const std::filesystem::path& path, const SequenceOptions& options);

bool is_single_image(const std::filesystem::path& path);
SequencePointer open_single_image(const std::filesystem::path& path,
                                  const SequenceOptions& options);

bool is_image_folder(const std::filesystem::path& path);
SequencePointer open_image_folder(const std::filesystem::path& path,
                                  const SequenceOptions& options);

}  // namespace symscene
