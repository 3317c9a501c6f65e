#pragma once

#include <filesystem>
#include <memory>

#include "symscene/io/sequence.hpp"

namespace symscene {

using SequencePointer = std::unique_ptr<DepthSequence>;

// For every layout (docs/formats.md): whether a path has it, and the sequence at that path.
bool is_own_layout(const std::filesystem::path& path);
SequencePointer open_own_layout(const std::filesystem::path& path, const SequenceOptions& options);
bool is_own_layout_without_camera(const std::filesystem::path& path);

bool is_tum(const std::filesystem::path& path);
SequencePointer open_tum(const std::filesystem::path& path, const SequenceOptions& options);

bool is_icl_nuim(const std::filesystem::path& path);
SequencePointer open_icl_nuim(const std::filesystem::path& path, const SequenceOptions& options);

bool is_seven_scenes(const std::filesystem::path& path);
SequencePointer open_seven_scenes(const std::filesystem::path& path,
                                  const SequenceOptions& options);

bool is_redwood(const std::filesystem::path& path);
SequencePointer open_redwood(const std::filesystem::path& path, const SequenceOptions& options);

bool is_bag(const std::filesystem::path& path);
SequencePointer open_bag(const std::filesystem::path& path, const SequenceOptions& options);

bool is_mcap(const std::filesystem::path& path);
SequencePointer open_mcap(const std::filesystem::path& path, const SequenceOptions& options);

/// A .db3 file of rosbag2, or its folder with .db3 or .mcap files.
bool is_rosbag2(const std::filesystem::path& path);
SequencePointer open_rosbag2(const std::filesystem::path& path, const SequenceOptions& options);

bool is_single_image(const std::filesystem::path& path);
SequencePointer open_single_image(const std::filesystem::path& path,
                                  const SequenceOptions& options);

bool is_image_folder(const std::filesystem::path& path);
SequencePointer open_image_folder(const std::filesystem::path& path,
                                  const SequenceOptions& options);

}  // namespace symscene
