#include "mcap_reader.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include "byte_cursor.hpp"
#include "compression.hpp"
#include "mcap_format.hpp"
#include "text.hpp"

namespace symscene {
namespace {

constexpr const char* an_mcap = "a whole MCAP file";

/// Largest record that is read, and largest decompressed chunk. [byte]
constexpr std::uint64_t largest_mcap_record = std::uint64_t{1} << 28;
constexpr std::size_t most_mcap_messages = std::size_t{1} << 24;
constexpr std::uint64_t record_head = 9;    ///< operation and length
constexpr std::uint64_t message_head = 22;  ///< channel, sequence number and two times

}  // namespace

std::uint32_t crc32_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

McapReader::McapReader(std::unique_ptr<ByteSource> source, std::string name)
    : source_(std::move(source)), name_(std::move(name)) {
  scan();
  cached_position_ = 0;
}

void McapReader::fail(const std::string& found) const { throw InputError(name_, an_mcap, found); }

McapReader::Record McapReader::record_at(std::uint64_t position) {
  ByteCursor cursor(source_->at(position, record_head), name_, an_mcap);
  Record record{cursor.number<std::uint8_t>(), position + record_head,
                cursor.number<std::uint64_t>()};
  if (record.size > source_->size() - record.position) {
    fail("a record that ends behind the file (`mcap recover` repairs what is cut off)");
  }
  return record;
}

std::string_view McapReader::content(const Record& record) {
  if (record.size > largest_mcap_record) fail("a record of more than 256 MiB");
  const std::string_view bytes = source_->at(record.position, record.size);
  if (bytes.size() != record.size) fail("a file that changes");
  return bytes;
}

void McapReader::scan() {
  const std::string start(source_->at(0, mcap_magic.size()));
  if (start != mcap_magic) fail(in_quotes(start));
  std::uint64_t position = mcap_magic.size();
  for (bool first = true;; first = false) {
    if (position >= source_->size()) {
      fail("no footer: it was not closed (`mcap recover` repairs it)");
    }
    const Record record = record_at(position);
    if (first && record.operation != mcap_header) fail("no header");
    position = record.position + record.size;
    if (record.operation == mcap_footer) break;
    scan_record(record);
  }
  if (source_->at(position, mcap_magic.size()) != mcap_magic) fail("no magic bytes at its end");
}

void McapReader::scan_record(const Record& record) {
  switch (record.operation) {
    case 0:
      return fail("a record of kind 0");
    case mcap_schema:
      return add_schema(content(record));
    case mcap_channel:
      return add_channel(content(record));
    case mcap_message:
      return add_message(source_->at(record.position, message_head), 0,
                         record.position + message_head, record.size);
    case mcap_chunk:
      return scan_chunk(record);
    default:  // indices, attachments, and what versions to come may add
      return;
  }
}

void McapReader::scan_chunk(const Record& record) {
  cached_ = decompressed(record);
  const std::string_view all = cached_;
  for (std::uint64_t at = 0; at < all.size();) {
    ByteCursor rest(all.substr(at), name_, "a record in a chunk");
    const auto operation = rest.number<std::uint8_t>();
    const auto size = rest.number<std::uint64_t>();
    const std::string_view bytes = rest.take(size);
    if (operation == mcap_schema) add_schema(bytes);
    if (operation == mcap_channel) add_channel(bytes);
    if (operation == mcap_message) {
      add_message(bytes, record.position, at + record_head + message_head, size);
    }
    at += record_head + size;
  }
}

void McapReader::add_schema(std::string_view content) {
  ByteCursor fields(content, name_, "a schema of MCAP");
  const auto id = fields.number<std::uint16_t>();
  const std::string name(fields.block());
  const std::string encoding(fields.block());
  if (!schemas_.try_emplace(id, name, encoding).second &&
      schemas_[id] != std::pair(name, encoding)) {
    fail(fmt::format("two schemas of id {}", id));
  }
}

void McapReader::add_channel(std::string_view content) {
  ByteCursor fields(content, name_, "a channel of MCAP");
  const auto id = fields.number<std::uint16_t>();
  const auto schema = fields.number<std::uint16_t>();
  McapChannel channel;
  channel.topic = fields.block();
  channel.message_encoding = fields.block();
  if (schema != 0) {  // 0 is none
    const auto found = schemas_.find(schema);
    if (found == schemas_.end()) fail(fmt::format("channel {} of unknown schema {}", id, schema));
    channel.schema = found->second.first, channel.schema_encoding = found->second.second;
  }
  const auto [place, is_new] = channels_.try_emplace(id, channel);
  if (!is_new && place->second != channel) fail(fmt::format("two channels of id {}", id));
}

void McapReader::add_message(std::string_view head, std::uint64_t chunk, std::uint64_t offset,
                             std::uint64_t size) {
  if (size < message_head) fail("a message without its head");
  ByteCursor fields(head, name_, "a message of MCAP");
  McapMessage message;
  message.channel = fields.number<std::uint16_t>();
  fields.take(4);  // sequence number
  message.log_time = fields.number<std::uint64_t>();
  if (!channels_.contains(message.channel)) {
    fail(fmt::format("a message of unknown channel {}", message.channel));
  }
  if (messages_.size() == most_mcap_messages) fail("more than 16 777 216 messages");
  message.chunk = chunk, message.offset = offset, message.size = size - message_head;
  messages_.push_back(message);
}

std::string McapReader::decompressed(const Record& record) {
  ByteCursor fields(content(record), name_, "a chunk of MCAP");
  fields.take(16);  // times of the first and the last message
  const auto size = fields.number<std::uint64_t>();
  const auto checksum = fields.number<std::uint32_t>();
  const std::string compression(fields.block());
  const auto stored = fields.number<std::uint64_t>();
  const std::string_view bytes = fields.take(stored);
  if (size > largest_mcap_record) fail("a chunk of more than 256 MiB");
  std::string records;
  if (compression == "lz4") {
    records = decompress_lz4(bytes, size, name_);
  } else if (compression == "zstd") {
    records = decompress_zstd(bytes, size, name_);
  } else if (compression.empty() && size == stored) {
    records = bytes;
  } else {
    fail(compression.empty() ? fmt::format("a chunk of {} bytes that says {}", stored, size)
                             : fmt::format("a chunk compressed by {}", in_quotes(compression)));
  }
  if (checksum != 0 && crc32_of(records) != checksum) fail("a chunk with another checksum");
  return records;
}

std::string McapReader::data(const McapMessage& message) {
  if (message.chunk == 0) {
    return std::string(content({mcap_message, message.offset, message.size}));
  }
  if (cached_position_ != message.chunk) {
    cached_position_ = 0;
    cached_ = decompressed(record_at(message.chunk - record_head));
    cached_position_ = message.chunk;
  }
  if (message.offset + message.size > cached_.size()) fail("a file that changes");
  return cached_.substr(message.offset, message.size);
}

}  // namespace symscene
