#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace symscene {

/// Throws InputError unless the records and the index of a ROS 1 bag (version 2.0) are consistent,
/// to the beginnings of messages, and lie inside the file; librosbag does not check this.
/// Compressed chunks are protected by checksums. `name` is the name of the file in messages.
void require_sound_bag(std::string_view bytes, const std::string& name);

/// The same of a file, which is read record by record: it may be larger than memory, and may be cut
/// short meanwhile. Throws InputError too if it cannot be read.
void require_sound_bag(const std::filesystem::path& path);

}  // namespace symscene
