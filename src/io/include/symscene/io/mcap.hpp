#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene {

/// How the chunks of an MCAP file are compressed. Both need their libraries at build time.
enum class McapCompression : std::uint8_t { none, lz4, zstd };

/// The compression of that name, "none", "lz4" or "zstd". Throws InputError for another name, or if
/// the build lacks it.
McapCompression mcap_compression_of(const std::string& name);

/// A result as an MCAP file that Foxglove and Lichtblick show: the cloud (`/cloud`), the closed
/// surfaces and names of objects (`/objects`), their axes and planes (`/symmetries`), and their
/// poses (`/poses`), as messages of Foxglove's schemas in JSON, in the frame `world`. All times are
/// 0. Throws InputError if a number is not finite.
std::string format_result_mcap(const SegmentationResult& result,
                               McapCompression compression = McapCompression::none);

/// The frames of a sequence as an MCAP file of ROS 2's messages, as a robot records them: depth in
/// whole millimetres (16UC1), colour, camera_info, and tf where poses are known. open_sequence()
/// reads it. Throws InputError if a frame cannot be read.
std::string format_sequence_mcap(const DepthSequence& sequence,
                                 McapCompression compression = McapCompression::none);

}  // namespace symscene
