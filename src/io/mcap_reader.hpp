#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "byte_source.hpp"

namespace symscene {

/// A channel of an MCAP file and its schema.
struct McapChannel {
  std::string topic;
  std::string message_encoding;  ///< "cdr", "ros1", "json", ...
  std::string schema;            ///< name: "sensor_msgs/msg/Image"
  std::string schema_encoding;   ///< "ros2msg", "jsonschema", ...

  bool operator==(const McapChannel&) const = default;
};

/// Where a message is.
struct McapMessage {
  std::uint16_t channel = 0;
  std::uint64_t log_time = 0;  ///< [ns]
  std::uint64_t chunk = 0;     ///< its record's position in the file; 0 for none
  std::uint64_t offset = 0;    ///< of its data in the decompressed chunk, or in the file
  std::uint64_t size = 0;
};

/// Reads MCAP files by one pass over their records. Chunks are decompressed one at a time.
class McapReader {
 public:
  /// Throws InputError unless the records are whole up to the footer. `name` is the name of the
  /// file in messages.
  McapReader(std::unique_ptr<ByteSource> source, std::string name);

  const std::map<std::uint16_t, McapChannel>& channels() const { return channels_; }
  const std::vector<McapMessage>& messages() const { return messages_; }  ///< in file order
  std::string data(const McapMessage& message);

 private:
  struct Record {
    std::uint8_t operation = 0;
    std::uint64_t position = 0;  ///< of its content
    std::uint64_t size = 0;
  };
  Record record_at(std::uint64_t position);
  std::string_view content(const Record& record);
  void scan();
  void scan_record(const Record& record);
  void scan_chunk(const Record& record);
  void add_schema(std::string_view content);
  void add_channel(std::string_view content);
  void add_message(std::string_view head, std::uint64_t chunk, std::uint64_t offset,
                   std::uint64_t size);
  std::string decompressed(const Record& record);
  [[noreturn]] void fail(const std::string& found) const;

  std::unique_ptr<ByteSource> source_;
  std::string name_;
  std::map<std::uint16_t, std::pair<std::string, std::string>> schemas_;  ///< name, encoding
  std::map<std::uint16_t, McapChannel> channels_;
  std::vector<McapMessage> messages_;
  std::uint64_t cached_position_ = 0;  ///< of the chunk whose records are cached; 0 for none
  std::string cached_;
};

}  // namespace symscene
