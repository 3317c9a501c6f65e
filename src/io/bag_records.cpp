// The records of a ROS 1 bag, format 2.0.
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "bag.hpp"
#include "byte_cursor.hpp"
#include "byte_source.hpp"
#include "io/atomic_file.hpp"
#include "text.hpp"

namespace symscene {
namespace {

constexpr std::string_view magic = "#ROSBAG V2.0\n";
constexpr const char* a_bag = "a whole ROS 1 bag of version 2.0";

/// Largest decompressed size of a chunk, and largest record, that is accepted. [byte]
constexpr std::uint32_t largest_chunk = std::uint32_t{1} << 28;
constexpr std::size_t largest_record = 2 * std::size_t{largest_chunk};
constexpr std::size_t length_size = 4;  ///< of the length before a header or data

enum Operation : std::uint8_t {
  message_data = 2,
  bag_header = 3,
  index_data = 4,
  chunk = 5,
  chunk_info = 6,
  connection = 7
};

/// A record: a header of fields name=value, and data.
struct Record {
  std::map<std::string_view, std::string_view> fields;
  std::string_view data;
  const std::string* name = nullptr;

  template <class Number>
  Number number(const char* field) const {
    const auto found = fields.find(field);
    if (found == fields.end() || found->second.size() != sizeof(Number)) {
      throw InputError(*name, a_bag, fmt::format("a record without its field {}", field));
    }
    return ByteCursor(found->second, *name, a_bag).number<Number>();
  }
  std::uint8_t operation() const { return number<std::uint8_t>("op"); }
  std::string_view text(const char* field) const {
    const auto found = fields.find(field);
    return found == fields.end() ? std::string_view() : found->second;
  }
};

Record take_record(ByteCursor& bytes, const std::string& name) {
  Record record;
  record.name = &name;
  ByteCursor header(bytes.block(), name, a_bag);
  while (!header.at_end()) {
    const std::string_view field = header.block();
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) {
      throw InputError(name, a_bag, "a field without a value");
    }
    record.fields.emplace(field.substr(0, equals), field.substr(equals + 1));
  }
  record.data = bytes.block();
  return record;
}

/// Checks the records in order and remembers what later ones refer to.
class BagCheck {
 public:
  BagCheck(ByteSource& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  void run() {
    const std::string start(bytes_.at(0, magic.size()));
    require(start == magic, in_quotes(start).c_str());
    bool first = true;
    for (std::uint64_t position = magic.size(); position < bytes_.size();) {
      ByteCursor cursor(bytes_.at(position, record_size(position)), name_, a_bag);
      const std::size_t size = cursor.left();
      const Record record = take_record(cursor, name_);
      require(first == (record.operation() == bag_header), "a header out of its place");
      first = false;
      check(record, position);
      position += size;
    }
    require(!first, "no header");
    check_index();
  }

 private:
  void require(bool holds, const char* found) const {
    if (!holds) throw InputError(name_, a_bag, found);
  }

  std::uint32_t length_at(std::uint64_t position) {
    require(position < bytes_.size(), "a record that ends behind the file");
    return ByteCursor(bytes_.at(position, length_size), name_, a_bag).number<std::uint32_t>();
  }

  /// The size of the record at a position: header and data, each behind its length.
  std::size_t record_size(std::uint64_t position) {
    const std::size_t header = length_size + length_at(position);
    const std::size_t size = header + length_size + length_at(position + header);
    require(size <= largest_record, "a record of more than 512 MiB");
    return size;
  }

  void check(const Record& record, std::uint64_t position) {
    switch (record.operation()) {
      case bag_header:
        return check_header(record);
      case chunk:
        return check_chunk(record, position);
      case index_data:
        return check_index_data(record);
      case connection:
        return check_connection(record, position);
      case chunk_info:
        return check_chunk_info(record, position);
      default:
        require(false, "a record of another kind");
    }
  }

  void check_header(const Record& record) {
    index_position_ = record.number<std::uint64_t>("index_pos");
    connections_due_ = record.number<std::uint32_t>("conn_count");
    chunks_due_ = record.number<std::uint32_t>("chunk_count");
    require(record.text("encryptor").empty(), "an encrypted one");
    if (index_position_ != 0) return;
    throw InputError(name_, a_bag,
                     "one without an index, as a recording that was cut off leaves "
                     "(rosbag reindex repairs it)");
  }

  void check_chunk(const Record& record, std::uint64_t position) {
    const auto size = record.number<std::uint32_t>("size");
    const std::string_view compression = record.text("compression");
    require(size <= largest_chunk, "a chunk of more than 256 MiB");
    require(compression == "none" || compression == "bz2" || compression == "lz4",
            "a chunk packed in another way");
    Chunk& added = chunks_[position];
    last_chunk_ = &added;
    added.size = size;
    if (compression != "none") return;
    require(size == record.data.size(), "a chunk of another size");
    added.messages = message_positions(record.data);
  }

  std::set<std::uint32_t> message_positions(std::string_view data) const {
    std::set<std::uint32_t> positions;
    ByteCursor rest(data, name_, a_bag);
    while (!rest.at_end()) {
      const auto position = static_cast<std::uint32_t>(data.size() - rest.left());
      const std::uint8_t operation = take_record(rest, name_).operation();
      require(operation == message_data || operation == connection,
              "a chunk of other things than messages");
      if (operation == message_data) positions.insert(positions.end(), position);
    }
    return positions;
  }

  void check_index_data(const Record& record) {
    require(last_chunk_ != nullptr, "an index without a chunk");
    ++last_chunk_->indices;
    used_connections_.insert(record.number<std::uint32_t>("conn"));
    const auto count = record.number<std::uint32_t>("count");
    require(record.number<std::uint32_t>("ver") == 1, "an index of another version");
    require(record.data.size() == std::size_t{count} * 12, "an index of another size");
    ByteCursor entries(record.data, name_, a_bag);
    while (!entries.at_end()) {
      entries.take(8);  // the time
      const auto offset = entries.number<std::uint32_t>();
      require(last_chunk_->messages ? last_chunk_->messages->contains(offset)
                                    : offset < last_chunk_->size,
              "an index that points elsewhere");
    }
  }

  void check_connection(const Record& record, std::uint64_t position) {
    require(index_position_ <= position, "a connection before the index");
    require(infos_ == 0, "a connection after the chunks' index");
    connections_.insert(record.number<std::uint32_t>("conn"));
    ++connection_records_;
    if (connection_records_ == 1) first_of_index_ = position;
    ByteCursor fields(record.data, name_, a_bag);
    while (!fields.at_end()) fields.block();
  }

  void check_chunk_info(const Record& record, std::uint64_t position) {
    if (infos_++ == 0 && connection_records_ == 0) first_of_index_ = position;
    require(record.number<std::uint32_t>("ver") == 1, "an index of another version");
    const auto found = chunks_.find(record.number<std::uint64_t>("chunk_pos"));
    require(found != chunks_.end(), "an index that points elsewhere");
    const auto count = record.number<std::uint32_t>("count");
    require(count == found->second.indices && record.data.size() == std::size_t{count} * 8,
            "an index of another size");
  }

  void check_index() const {
    const bool empty = connections_due_ == 0 && chunks_due_ == 0;
    require(index_position_ == (empty ? index_position_ : first_of_index_) &&
                index_position_ <= bytes_.size(),
            "an index in another place");
    require(connection_records_ == connections_due_ && infos_ == chunks_due_,
            "another number of chunks or connections");
    require(std::includes(connections_.begin(), connections_.end(), used_connections_.begin(),
                          used_connections_.end()),
            "messages of unknown connections");
  }

  struct Chunk {
    std::uint32_t size = 0;  ///< decompressed [byte]
    std::size_t indices = 0;
    std::optional<std::set<std::uint32_t>> messages;  ///< offsets of messages, unless compressed
  };

  ByteSource& bytes_;
  const std::string& name_;
  std::uint64_t index_position_ = 0;
  std::uint32_t connections_due_ = 0;
  std::uint32_t chunks_due_ = 0;
  std::map<std::uint64_t, Chunk> chunks_;
  Chunk* last_chunk_ = nullptr;
  std::set<std::uint32_t> connections_;
  std::set<std::uint32_t> used_connections_;
  std::size_t connection_records_ = 0;
  std::size_t infos_ = 0;
  std::uint64_t first_of_index_ = 0;
};

}  // namespace

void require_sound_bag(std::string_view bytes, const std::string& name) {
  BytesInMemory source(bytes);
  BagCheck(source, name).run();
}

void require_sound_bag(const std::filesystem::path& path) {
  require_regular_file(path);
  BytesInFile source(path);
  BagCheck(source, path.string()).run();
}

}  // namespace symscene
