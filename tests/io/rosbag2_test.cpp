// Recordings of rosbag2 in the format of SQLite, written by SQLite if it is installed.
#include "io/compression.hpp"
#include "io/recording.hpp"
#include "io/recording_support.hpp"

#ifdef SYMSCENE_HAS_SQLITE
#include <sqlite3.h>
#endif

namespace symscene {
namespace {

namespace fs = std::filesystem;
using namespace io_test;

class Rosbag2 : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const fs::path file = folder_ / "table.db3";
};

TEST_F(Rosbag2, OtherFilesAreRefused) {
  write_text(file, "text");
  EXPECT_TRUE(refusal([&] { open_sequence(file); }).starts_with(file.string() + ": expected"));
}

TEST_F(Rosbag2, CompressedFilesAreNamedInTheRefusal) {
  fs::create_directory(folder_ / "bag");
  write_text(folder_ / "bag" / "metadata.yaml", "rosbag2_bagfile_information:\n");
  write_text(folder_ / "bag" / "table_0.db3.zstd", "");
  EXPECT_EQ(refusal([&] { open_sequence(folder_ / "bag"); }),
            (folder_ / "bag").string() +
                ": expected files .db3 or .mcap (zstd -d decompresses them), found "
                "table_0.db3.zstd");
}

TEST_F(Rosbag2, TheFilesOfAFolderAreOneSequence) {
  fs::create_directory(folder_ / "bag");
  write_text(folder_ / "bag" / "metadata.yaml", "rosbag2_bagfile_information:\n");
  const TestMessages all = small_recording();
  write_text(folder_ / "bag" / "table_0.mcap", mcap_of({all[0], all[1]}));
  write_text(folder_ / "bag" / "table_1.mcap", mcap_of({all[2], all[3]}));
  const auto sequence = open_sequence(folder_ / "bag");
  EXPECT_EQ(sequence->layout(), "rosbag2");
  expect_small_recording(*sequence);
}

#ifdef SYMSCENE_HAS_SQLITE

void execute(sqlite3* database, const std::string& sql, const std::string* blob = nullptr) {
  sqlite3_stmt* statement = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  if (blob != nullptr) {
    sqlite3_bind_blob(statement, 1, blob->data(), static_cast<int>(blob->size()), SQLITE_STATIC);
  }
  EXPECT_EQ(sqlite3_step(statement), SQLITE_DONE) << sqlite3_errmsg(database);
  sqlite3_finalize(statement);
}

/// Tables and columns as rosbag2 makes them.
void write_db3(const fs::path& path, const TestMessages& messages) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.string().c_str(), &database), SQLITE_OK);
  execute(database, "PRAGMA page_size = 512");
  execute(database,
          "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
          "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)");
  execute(database,
          "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp "
          "INTEGER NOT NULL, data BLOB NOT NULL)");
  std::map<std::string, std::size_t> topics;
  for (const TestMessage& message : messages) {
    const auto [topic, is_new] = topics.try_emplace(message.topic, topics.size() + 1);
    const std::string id = std::to_string(topic->second);
    if (is_new) {
      execute(database, "INSERT INTO topics VALUES(" + id + ", '" + message.topic + "', '" +
                            message.type + "', 'cdr', '')");
    }
    execute(database,
            "INSERT INTO messages(topic_id, timestamp, data) VALUES(" + id + ", " +
                std::to_string(message.time) + ", ?)",
            &message.data);
  }
  sqlite3_close(database);
}

TEST_F(Rosbag2, DepthImagesOfAFileAreRead) {
  write_db3(file, small_recording());
  const auto sequence = open_sequence(file);
  EXPECT_EQ(sequence->layout(), "rosbag2");
  expect_small_recording(*sequence);
}

TEST_F(Rosbag2, MessagesCompressedOneByOneAreRead) {
  if (!has_zstd()) GTEST_SKIP() << "needs libzstd-dev";
  TestMessages messages = small_recording();
  for (TestMessage& message : messages) message.data = compress_zstd(message.data);
  write_db3(file, messages);
  expect_small_recording(*open_sequence(file));
}

TEST_F(Rosbag2, ViewsInPlaceOfTablesAreRefused) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.string().c_str(), &database), SQLITE_OK);
  execute(database, "CREATE VIEW topics AS SELECT 1 AS id");
  execute(database, "CREATE VIEW messages AS SELECT 1 AS id");
  sqlite3_close(database);
  EXPECT_NE(refusal([&] { open_sequence(file); }).find("one without tables of topics and messages"),
            std::string::npos);
}

TEST_F(Rosbag2, DamagedFilesAreReadOrRefused) {
  write_db3(file, small_recording());
  damage(
      read_text(file),
      [&](std::string_view damaged) {
        const RecordingPointer recording = open_sqlite_recording(damaged, "x");
        for (const RecordedTopic& topic : recording->topics()) {
          for (const RecordedMessage& message : recording->messages(topic.name)) {
            recording->bytes(message);
          }
        }
      },
      200, 500);
}

#endif

}  // namespace
}  // namespace symscene
