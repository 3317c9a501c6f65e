#include "io/atomic_file.hpp"

#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;
namespace fs = std::filesystem;

using Names = std::vector<std::string>;

DirectoryLayout layout() {
  return {"a test folder", "marker", [](const std::string& relative) {
            return relative == "marker" || relative == "sub/" || relative == "sub/a";
          }};
}

void write_folder(const fs::path& path, const std::string& text) {
  AtomicDirectory folder(path, layout());
  folder.write("marker", text);
  folder.write("sub/a", text);
  folder.commit();
}

TEST(AtomicFile, BytesAreReadBackAndNothingElseIsLeft) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n", 5);
  write_file_atomically(folder / "file", "old, longer than the new");
  write_file_atomically(folder / "file", bytes);
  EXPECT_EQ(read_file(folder / "file"), bytes);
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(AtomicFile, AFailureLeavesTheOldFileUnchangedAndNothingBehind) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "target/inside");
  EXPECT_THROW(write_file_atomically(folder / "target", "x"), InputError);
  EXPECT_EQ(folder.names(), Names{"target"});
  EXPECT_THROW(write_file_atomically(folder / "missing/file", "x"), InputError);
  EXPECT_EQ(folder.names(), Names{"target"});
}

TEST(AtomicFile, ErrorsNameTheFile) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "dir");
  EXPECT_EQ(refusal([&] { read_file(folder / "none"); }),
            (folder / "none").string() + ": expected a file, found nothing of that name");
  EXPECT_EQ(refusal([&] { read_file(folder / "dir"); }),
            (folder / "dir").string() + ": expected a file, found a folder");
  write_text(folder / "locked", "x");
  fs::permissions(folder / "locked", fs::perms::none);
  if (geteuid() == 0) GTEST_SKIP() << "skipped: the superuser reads every file";
  EXPECT_THROW(read_file(folder / "locked"), InputError);
}

TEST(AtomicFile, AFileOfUnknownSizeIsReadCompletely) {
  if (!fs::exists("/proc/self/status")) GTEST_SKIP() << "skipped: no /proc";
  EXPECT_GT(read_file("/proc/self/status").size(), 100U);
}

TEST(AtomicDirectory, AnOldFolderIsReplacedCompletely) {
  const TemporaryFolder folder;
  write_folder(folder / "deep/out", "first");
  write_folder(folder / "deep/out/", "second");
  EXPECT_EQ(read_text(folder / "deep/out/marker"), "second");
  EXPECT_EQ(read_text(folder / "deep/out/sub/a"), "second");
  AtomicDirectory smaller(folder / "deep/out", layout());
  smaller.write("marker", "third");
  EXPECT_TRUE(fs::exists(folder / "deep/out/sub/a")) << "nothing changes before commit";
  smaller.commit();
  EXPECT_FALSE(fs::exists(folder / "deep/out/sub"));
  EXPECT_EQ(folder.names(), Names{"deep"});
}

TEST(AtomicDirectory, WithoutCommitNothingChangesAndNothingRemains) {
  const TemporaryFolder folder;
  write_folder(folder / "out", "first");
  {
    AtomicDirectory unfinished(folder / "out", layout());
    unfinished.write("marker", "second");
    EXPECT_EQ(folder.names().size(), 2U);
  }
  EXPECT_EQ(folder.names(), Names{"out"});
  EXPECT_EQ(read_text(folder / "out/marker"), "first");
}

TEST(AtomicDirectory, FoldersWithOtherFilesAreNotReplaced) {
  const TemporaryFolder folder;
  write_folder(folder / "out", "first");
  write_text(folder / "out/thesis.tex", "years of work");
  EXPECT_EQ(refusal([&] { write_folder(folder / "out", "second"); }),
            (folder / "out").string() +
                ": expected no folder yet, an empty one, or a test folder to replace, found a "
                "folder that holds thesis.tex");
  fs::create_directories(folder / "unmarked/sub");
  EXPECT_EQ(refusal([&] { write_folder(folder / "unmarked", "second"); }),
            (folder / "unmarked").string() +
                ": expected no folder yet, an empty one, or a test folder to replace, found a "
                "folder without marker");
  write_text(folder / "file", "x");
  EXPECT_THROW(write_folder(folder / "file", "second"), InputError);
  EXPECT_EQ(read_text(folder / "out/marker"), "first");
  EXPECT_EQ(read_text(folder / "out/thesis.tex"), "years of work");
  EXPECT_EQ(folder.names(), (Names{"file", "out", "unmarked"}));
}

TEST(AtomicDirectory, AFileThatAppearsBeforeCommitIsKept) {
  const TemporaryFolder folder;
  write_folder(folder / "out", "first");
  AtomicDirectory second(folder / "out", layout());
  second.write("marker", "second");
  write_text(folder / "out/notes", "just written");
  EXPECT_THROW(second.commit(), InputError);
  EXPECT_EQ(read_text(folder / "out/notes"), "just written");
}

TEST(AtomicDirectory, ALinkToAFolderStaysALink) {
  const TemporaryFolder folder;
  write_folder(folder / "real", "first");
  fs::create_directory_symlink(folder / "real", folder / "link");
  write_folder(folder / "link", "second");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_text(folder / "real/marker"), "second");
}

TEST(AtomicDirectory, AnEmptyFolderIsFilled) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "out");
  write_folder(folder / "out", "first");
  EXPECT_EQ(read_text(folder / "out/marker"), "first");
}

}  // namespace
}  // namespace symscene
