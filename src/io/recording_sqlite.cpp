// The messages of a rosbag2 file in the format of SQLite.
#include "recording.hpp"
#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_SQLITE
#include <map>
#include <mutex>

#include <fmt/format.h>
#include <sqlite3.h>

#include "compression.hpp"
#include "io/atomic_file.hpp"
#endif

namespace symscene {

namespace fs = std::filesystem;

#ifndef SYMSCENE_HAS_SQLITE

namespace {
[[noreturn]] void refuse_sqlite(const std::string& name) {
  throw InputError(name,
                   "a build with a reader of rosbag2's .db3 files (install libsqlite3-dev and "
                   "build again)",
                   "one without");
}
}  // namespace

RecordingPointer open_sqlite_recording(const fs::path& path) { refuse_sqlite(path.string()); }
RecordingPointer open_sqlite_recording(std::string_view, const std::string& name) {
  refuse_sqlite(name);
}

#else

namespace {

constexpr const char* a_rosbag2 = "a file of rosbag2 in the format of SQLite";
constexpr int largest_value = 1 << 28;  ///< of one message [byte]
constexpr std::size_t most_rows = std::size_t{1} << 24;

using Database = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;

/// A statement of SQL whose rows are read one after another.
class Statement {
 public:
  Statement(sqlite3* database, const std::string& name, const char* sql)
      : database_(database), name_(name), statement_(nullptr, sqlite3_finalize) {
    sqlite3_stmt* made = nullptr;
    const int status = sqlite3_prepare_v2(database, sql, -1, &made, nullptr);
    statement_.reset(made);
    if (status != SQLITE_OK) fail();
  }

  void bind(int place, std::int64_t value) {
    if (sqlite3_bind_int64(statement_.get(), place, value) != SQLITE_OK) fail();
  }
  /// Whether there is a further row.
  bool next() {
    const int status = sqlite3_step(statement_.get());
    if (status != SQLITE_ROW && status != SQLITE_DONE) fail();
    return status == SQLITE_ROW;
  }
  std::int64_t number(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string bytes(int column) const {
    const void* data = sqlite3_column_blob(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return data == nullptr
               ? std::string()
               : std::string(static_cast<const char*>(data), static_cast<std::size_t>(size));
  }

 private:
  [[noreturn]] void fail() const { throw InputError(name_, a_rosbag2, sqlite3_errmsg(database_)); }

  sqlite3* database_;
  const std::string& name_;
  std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> statement_;
};

/// What a file may do that was made to do harm: nothing beyond its tables.
void restrict(sqlite3* database) {
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH, largest_value);
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_exec(database, "PRAGMA cell_size_check=ON; PRAGMA mmap_size=0", nullptr, nullptr,
               nullptr);
}

Database open_database(const std::string& file, const std::string& name) {
  sqlite3* made = nullptr;
  const int status = sqlite3_open_v2(file.c_str(), &made, SQLITE_OPEN_READONLY, nullptr);
  Database database(made, sqlite3_close);
  if (status != SQLITE_OK) {
    throw InputError(name, a_rosbag2, made != nullptr ? sqlite3_errmsg(made) : "no memory");
  }
  restrict(database.get());
  return database;
}

class SqliteRecording final : public Recording {
 public:
  SqliteRecording(Database database, std::string name)
      : database_(std::move(database)), name_(std::move(name)) {
    require_tables();
    Statement rows = select("SELECT id, name, type, serialization_format FROM topics");
    while (rows.next()) {
      if (topics_.size() == most_rows) throw InputError(name_, a_rosbag2, "too many topics");
      if (rows.bytes(3) != "cdr") continue;
      RecordedTopic topic{rows.bytes(1), ros1_type(rows.bytes(2)), RosFormat::cdr};
      topics_.try_emplace(topic.name, rows.number(0), topic);
    }
  }

  std::vector<RecordedTopic> topics() const override {
    std::vector<RecordedTopic> topics;
    for (const auto& [name, entry] : topics_) topics.push_back(entry.second);
    return topics;
  }

  std::vector<RecordedMessage> messages(const std::string& topic) override {
    std::vector<RecordedMessage> found;
    const auto entry = topics_.find(topic);
    if (entry == topics_.end()) return found;
    Statement rows =
        select("SELECT id, timestamp FROM messages WHERE topic_id = ? ORDER BY timestamp, id");
    rows.bind(1, entry->second.first);
    while (rows.next()) {
      if (found.size() == most_rows) throw InputError(name_, a_rosbag2, "too many messages");
      found.push_back({1e-9 * static_cast<double>(rows.number(1)), 0,
                       static_cast<std::uint64_t>(rows.number(0))});
    }
    return found;
  }

  std::string bytes(const RecordedMessage& message) const override {
    const std::lock_guard lock(mutex_);
    Statement rows = select("SELECT data FROM messages WHERE id = ?");
    rows.bind(1, static_cast<std::int64_t>(message.place));
    if (!rows.next()) throw InputError(name_, a_rosbag2, "a file that changes");
    std::string bytes = rows.bytes(0);
    // rosbag2 may compress each message; CDR begins with a zero.
    return is_zstd(bytes) ? decompress_zstd_frame(bytes, largest_value, name_) : bytes;
  }

 private:
  Statement select(const char* sql) const { return {database_.get(), name_, sql}; }

  /// Virtual tables have no pages of their own.
  void require_tables() const {
    Statement rows = select(
        "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND rootpage > 0 AND name IN "
        "('topics', 'messages')");
    if (!rows.next() || rows.number(0) != 2) {
      throw InputError(name_, a_rosbag2, "one without tables of topics and messages");
    }
  }

  Database database_;
  std::string name_;
  std::map<std::string, std::pair<std::int64_t, RecordedTopic>> topics_;  ///< with their ids
  mutable std::mutex mutex_;
};

}  // namespace

RecordingPointer open_sqlite_recording(const fs::path& path) {
  require_regular_file(path);
  return std::make_unique<SqliteRecording>(open_database(path.string(), path.string()),
                                           path.string());
}

RecordingPointer open_sqlite_recording(std::string_view bytes, const std::string& name) {
  Database database = open_database(":memory:", name);
  auto* data = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  if (sqlite3_deserialize(database.get(), "main", data, size, size, SQLITE_DESERIALIZE_READONLY) !=
      SQLITE_OK) {
    throw InputError(name, a_rosbag2, sqlite3_errmsg(database.get()));
  }
  return std::make_unique<SqliteRecording>(std::move(database), name);
}

#endif

}  // namespace symscene
