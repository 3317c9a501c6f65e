#pragma once

#include <cstdint>
#include <string_view>

namespace symscene {

// The container MCAP, version 0 (https://mcap.dev/spec).
constexpr std::string_view mcap_magic("\x89MCAP0\r\n", 8);

enum McapOperation : std::uint8_t {
  mcap_header = 0x01,
  mcap_footer = 0x02,
  mcap_schema = 0x03,
  mcap_channel = 0x04,
  mcap_message = 0x05,
  mcap_chunk = 0x06,
  mcap_message_index = 0x07,
  mcap_chunk_index = 0x08,
  mcap_statistics = 0x0B,
  mcap_summary_offset = 0x0E,
  mcap_data_end = 0x0F
};

/// CRC-32 of ISO 3309, as zlib computes it.
std::uint32_t crc32_of(std::string_view bytes);

}  // namespace symscene
