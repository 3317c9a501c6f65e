#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mcap_reader.hpp"
#include "symscene/io/mcap.hpp"

namespace symscene {

/// Writes an MCAP file, in memory: chunks with indices, and the summary by which programs find
/// them.
class McapWriter {
 public:
  /// `profile` tells what the channels are: "ros2", or nothing.
  McapWriter(std::string_view profile, McapCompression compression);

  /// Adds a channel and its schema, whose text is `definition`. Returns its number.
  std::uint16_t add_channel(const McapChannel& channel, std::string_view definition);

  /// Adds a message that was recorded at `time`. [ns]
  void add_message(std::uint16_t channel, std::uint64_t time, std::string_view data);

  std::string finish();

 private:
  struct Chunk {
    std::uint64_t position = 0;
    std::uint64_t length = 0;  ///< of its record
    std::uint64_t first = 0;   ///< time of its messages [ns]
    std::uint64_t last = 0;
    std::map<std::uint16_t, std::uint64_t> indices;  ///< position of each channel's index
    std::uint64_t indices_length = 0;
    std::uint64_t stored = 0;  ///< [byte]
    std::uint64_t size = 0;    ///< decompressed [byte]
  };
  /// Times and places of a channel's messages in the chunk.
  using MessageIndex = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

  void end_chunk();
  std::string compressed() const;
  std::string statistics() const;
  std::string chunk_index(const Chunk& chunk) const;

  McapCompression compression_;
  std::string file_;
  std::string records_;  ///< of the chunk that is being filled
  std::uint64_t first_ = 0, last_ = 0;
  std::map<std::uint16_t, MessageIndex> index_;
  std::string schema_records_, channel_records_;
  std::uint16_t channels_ = 0;
  std::vector<Chunk> chunks_;
  std::map<std::uint16_t, std::uint64_t> counts_;  ///< messages per channel
  std::uint32_t sequence_ = 0;
};

}  // namespace symscene
