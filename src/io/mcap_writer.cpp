#include "mcap_writer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "compression.hpp"
#include "core/little_endian.hpp"
#include "mcap_format.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

/// Chunks end when they hold this many bytes.
constexpr std::size_t full_mcap_chunk = std::size_t{1} << 20;

template <class Integer>
void put(std::string& bytes, Integer value) {
  append_little_endian(bytes, value);
}

void put_text(std::string& bytes, std::string_view text) {
  put(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.append(text);
}

void put_map(std::string& bytes, const std::map<std::uint16_t, std::uint64_t>& map) {
  put(bytes, static_cast<std::uint32_t>(map.size() * 10));
  for (const auto& [key, value] : map) put(bytes, key), put(bytes, value);
}

void put_record(std::string& bytes, McapOperation operation, std::string_view content) {
  put(bytes, static_cast<std::uint8_t>(operation));
  put(bytes, std::uint64_t{content.size()});
  bytes.append(content);
}

const char* name_of(McapCompression compression) {
  if (compression == McapCompression::lz4) return "lz4";
  return compression == McapCompression::zstd ? "zstd" : "";
}

}  // namespace

McapCompression mcap_compression_of(const std::string& name) {
  if (name == "none") return McapCompression::none;
  if (name == "lz4" && has_lz4()) return McapCompression::lz4;
  if (name == "zstd" && has_zstd()) return McapCompression::zstd;
  if (name != "lz4" && name != "zstd") {
    throw InputError("compression", "none, lz4 or zstd", in_quotes(name));
  }
  throw InputError("compression " + name,
                   fmt::format("a build with it (install lib{}-dev and build again)", name),
                   "one without");
}

McapWriter::McapWriter(std::string_view profile, McapCompression compression)
    : compression_(compression), file_(mcap_magic) {
  std::string header;
  put_text(header, profile);
  put_text(header, "symscene");
  put_record(file_, mcap_header, header);
}

std::uint16_t McapWriter::add_channel(const McapChannel& channel, std::string_view definition) {
  const std::uint16_t id = ++channels_;  // 0 stands for no schema
  std::string schema;
  put(schema, id);
  put_text(schema, channel.schema);
  put_text(schema, channel.schema_encoding);
  put_text(schema, definition);
  put_record(schema_records_, mcap_schema, schema);
  put_record(records_, mcap_schema, schema);
  std::string fields;
  put(fields, id);
  put(fields, id);
  put_text(fields, channel.topic);
  put_text(fields, channel.message_encoding);
  put(fields, std::uint32_t{0});  // no metadata
  put_record(channel_records_, mcap_channel, fields);
  put_record(records_, mcap_channel, fields);
  counts_[id] = 0;
  return id;
}

void McapWriter::add_message(std::uint16_t channel, std::uint64_t time, std::string_view data) {
  first_ = index_.empty() ? time : std::min(first_, time);
  last_ = index_.empty() ? time : std::max(last_, time);
  index_[channel].emplace_back(time, records_.size());
  ++counts_[channel];
  std::string message;
  put(message, channel);
  put(message, sequence_++);
  put(message, time);  // recorded
  put(message, time);  // published
  message.append(data);
  put_record(records_, mcap_message, message);
  if (records_.size() >= full_mcap_chunk) end_chunk();
}

std::string McapWriter::compressed() const {
  if (compression_ == McapCompression::lz4) return compress_lz4(records_);
  return compression_ == McapCompression::zstd ? compress_zstd(records_) : records_;
}

void McapWriter::end_chunk() {
  if (records_.empty()) return;
  const std::string stored = compressed();
  Chunk chunk{file_.size(), 0, first_, last_, {}, 0, stored.size(), records_.size()};
  std::string content;
  put(content, chunk.first);
  put(content, chunk.last);
  put(content, chunk.size);
  put(content, crc32_of(records_));
  put_text(content, name_of(compression_));
  put(content, chunk.stored);
  content.append(stored);
  put_record(file_, mcap_chunk, content);
  chunk.length = file_.size() - chunk.position;
  for (const auto& [channel, messages] : index_) {
    chunk.indices[channel] = file_.size();
    std::string index;
    put(index, channel);
    put(index, static_cast<std::uint32_t>(messages.size() * 16));
    for (const auto& [time, place] : messages) put(index, time), put(index, std::uint64_t{place});
    put_record(file_, mcap_message_index, index);
  }
  chunk.indices_length = file_.size() - chunk.position - chunk.length;
  chunks_.push_back(std::move(chunk));
  records_.clear();
  index_.clear();
}

std::string McapWriter::statistics() const {
  std::uint64_t messages = 0;
  for (const auto& [channel, count] : counts_) messages += count;
  std::uint64_t first = chunks_.empty() ? 0 : chunks_.front().first;
  std::uint64_t last = 0;
  for (const Chunk& chunk : chunks_) {
    first = std::min(first, chunk.first), last = std::max(last, chunk.last);
  }
  std::string content;
  put(content, messages);
  put(content, channels_);                 // schemas
  put(content, std::uint32_t{channels_});  // channels
  put(content, std::uint32_t{0});          // attachments
  put(content, std::uint32_t{0});          // metadata
  put(content, static_cast<std::uint32_t>(chunks_.size()));
  put(content, first);
  put(content, last);
  put_map(content, counts_);
  return content;
}

std::string McapWriter::chunk_index(const Chunk& chunk) const {
  std::string content;
  put(content, chunk.first);
  put(content, chunk.last);
  put(content, chunk.position);
  put(content, chunk.length);
  put_map(content, chunk.indices);
  put(content, chunk.indices_length);
  put_text(content, name_of(compression_));
  put(content, chunk.stored);
  put(content, chunk.size);
  return content;
}

std::string McapWriter::finish() {
  end_chunk();
  std::string end;
  put(end, std::uint32_t{0});  // no checksum of the data: chunks have their own
  put_record(file_, mcap_data_end, end);

  const std::uint64_t summary_start = file_.size();
  std::string statistics_record, index_records, summary, offsets;
  put_record(statistics_record, mcap_statistics, statistics());
  for (const Chunk& chunk : chunks_)
    put_record(index_records, mcap_chunk_index, chunk_index(chunk));
  const std::pair<McapOperation, const std::string*> groups[] = {
      {mcap_schema, &schema_records_},
      {mcap_channel, &channel_records_},
      {mcap_statistics, &statistics_record},
      {mcap_chunk_index, &index_records}};
  for (const auto& [operation, records] : groups) {
    if (records->empty()) continue;
    std::string offset;
    put(offset, static_cast<std::uint8_t>(operation));
    put(offset, summary_start + summary.size());
    put(offset, std::uint64_t{records->size()});
    put_record(offsets, mcap_summary_offset, offset);
    summary += *records;
  }
  const std::uint64_t offsets_start = summary_start + summary.size();
  summary += offsets;
  // The checksum is of the summary and of the footer before the checksum.
  put(summary, static_cast<std::uint8_t>(mcap_footer));
  put(summary, std::uint64_t{20});
  put(summary, summary_start);
  put(summary, offsets_start);
  put(summary, crc32_of(summary));
  file_ += summary;
  file_ += mcap_magic;
  return std::move(file_);
}

}  // namespace symscene
