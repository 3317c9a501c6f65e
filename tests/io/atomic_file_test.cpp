#include "io/atomic_file.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "io/io_support.hpp"
#include "io/temporary_name.hpp"
#include "symscene/io/staging.hpp"

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

TEST(AtomicFile, WhatHasNoEndIsNotRead) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusal([&] { read_file(folder / "pipe"); }),
            (folder / "pipe").string() + ": expected a file, found a pipe");
  fs::create_symlink("/dev/zero", folder / "zero");
  EXPECT_EQ(refusal([&] { read_file(folder / "zero"); }),
            (folder / "zero").string() + ": expected a file, found a device");
  write_text(folder / "sparse", "x");
  fs::resize_file(folder / "sparse", std::uintmax_t{1} << 40);
  EXPECT_NE(refusal([&] { read_file(folder / "sparse"); }).find("at most 4294 MB"),
            std::string::npos);
  write_text(folder / "small", "abc");
  EXPECT_EQ(read_file(folder / "small", 3), "abc");
  EXPECT_THROW(read_file(folder / "small", 2), InputError);
}

/// Runs `work` in another process and returns how that ended.
template <class Work>
int status_of(const Work& work) {
  const pid_t process = fork();
  if (process == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(process, &status, 0);
  return status;
}

TEST(AtomicDirectory, WhatADeadProcessLeftIsRemovedByTheNextWriter) {
  const TemporaryFolder folder;
  write_text(folder / ".out.tmp-1", "not ours");
  status_of([&] {
    fs::create_directory(temporary_beside(folder / "out"));
    write_text(temporary_beside(folder / "other"), "x");
  });
  ASSERT_EQ(folder.names().size(), 3U);
  const fs::path living = temporary_beside(folder / "out");
  fs::create_directory(living);
  write_folder(folder / "out", "x");
  write_file_atomically(folder / "other", "x");
  EXPECT_EQ(folder.names(), (Names{".out.tmp-1", living.filename().string(), "other", "out"}));
}

TEST(AtomicDirectory, WhatADeadProcessSetAsideIsWhereItWasBeforeTheNextOneCommits) {
  const TemporaryFolder folder;
  write_folder(folder / "out", "first");
  status_of([&] { fs::rename(folder / "out", set_aside_beside(folder / "out")); });
  ASSERT_FALSE(fs::exists(folder / "out"));
  { const AtomicDirectory given_up(folder / "out", layout()); }
  EXPECT_EQ(folder.names(), Names{"out"});
  EXPECT_EQ(read_text(folder / "out/sub/a"), "first");
}

TEST(AtomicDirectory, WhatADeadProcessSetAsideDoesNotReplaceWhatTookItsPlace) {
  const TemporaryFolder folder;
  write_folder(folder / "out", "first");
  status_of([&] { fs::rename(folder / "out", set_aside_beside(folder / "out")); });
  fs::create_directory(folder / "out");
  write_text(folder / "out/marker", "second");
  { const AtomicDirectory given_up(folder / "out", layout()); }
  EXPECT_EQ(folder.names(), Names{"out"});
  EXPECT_EQ(read_text(folder / "out/marker"), "second");
}

TEST(AtomicDirectory, WhatALivingProcessSetAsideIsLeftAlone) {
  const TemporaryFolder folder;
  write_folder(folder / "out", "first");
  const fs::path aside = set_aside_beside(folder / "out");
  fs::rename(folder / "out", aside);
  write_folder(folder / "out", "second");
  EXPECT_EQ(read_text(aside / "marker"), "first");
  EXPECT_EQ(read_text(folder / "out/marker"), "second");
}

TEST(AtomicDirectory, IsRemovedIfASignalEndsTheProcess) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    const int status = status_of([&] {
      remove_staging_on_signals();
      const AtomicDirectory writing(folder / "out", layout());
      writing.write("marker", "x");
      writing.write("sub/a", "x");
      raise(signal);
    });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
    EXPECT_EQ(folder.names(), Names{});
  }
}

TEST(AtomicDirectory, RefusesToGoOnWithoutWhatWasWrittenBefore) {
  const TemporaryFolder folder;
  AtomicDirectory writing(folder / "out", layout());
  writing.write("marker", "x");
  fs::remove_all(writing.staging());
  EXPECT_NE(refusal([&] { writing.write("sub/a", "x"); }).find("found that it was removed"),
            std::string::npos);
  EXPECT_THROW(writing.commit(), InputError);
  EXPECT_EQ(folder.names(), Names{});
}

}  // namespace
}  // namespace symscene
