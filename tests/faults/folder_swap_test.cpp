// A folder that is replaced where the file system cannot exchange two names.
#include <csignal>

#include "faults/faults.hpp"

namespace symscene::testing {
namespace {

/// On a file system that cannot exchange two names.
class FaultsWithoutExchange : public Faults {
 protected:
  void SetUp() override {
    setenv("SYMSCENE_NO_EXCHANGE", "1", 1);
    Faults::SetUp();
    begin_with(older_outputs());
  }
  void TearDown() override { unsetenv("SYMSCENE_NO_EXCHANGE"); }

  /// The old folder under the name by which it is set aside; empty if there is none.
  static Files set_aside_of(const Files& files, const std::string& output) {
    for (const auto& [name, bytes] : files)
      if (name.starts_with("." + output + ".tmp-") && name.ends_with(".old/"))
        return renamed(part_of(files, name.substr(0, name.size() - 1)), output);
    return {};
  }

  /// As part_of() gives them, below the folder `to`.
  static Files renamed(const Files& part, const std::string& to) {
    Files result;
    for (const auto& [name, bytes] : part) result[to + name.substr(name.find('/'))] = bytes;
    return result;
  }

  void expect_old_or_new(const Files& files, const std::string& output) const {
    const Files part = part_of(files, output);
    const Files& kept = part.empty() ? set_aside_of(files, output) : part;
    EXPECT_TRUE(kept == part_of(before(), output) || kept == part_of(after(), output))
        << output << " is lost or partly written";
  }
};

TEST_P(FaultsWithoutExchange, OfRenamesLeaveTheOldFolderOrTheNewOne) {
  ASSERT_GE(count(Kind::rename), 3U) << "aside, in its place, to be removed";
  for (std::uint64_t call = 1; call <= count(Kind::rename); ++call) check_fault(Kind::rename, call);
}

TEST_P(FaultsWithoutExchange, AKilledProcessLosesNoFolderAndTheNextRunHasItBack) {
  const std::string& output = GetParam().outputs.front();
  const std::uint64_t last = count(Kind::kill);
  bool was_set_aside = false;
  for (std::uint64_t call = last - 4; call <= last; ++call) {
    SCOPED_TRACE("kill " + std::to_string(call));
    EXPECT_EQ(run(Kind::kill, call).signal, SIGKILL);
    const Files left = files_below(outputs_folder());
    expect_old_or_new(left, output);
    was_set_aside = was_set_aside || part_of(left, output).empty();
    EXPECT_NE(run(Kind::write, 1).code, 0);
    EXPECT_FALSE(part_of(files_below(outputs_folder()), output).empty()) << "not restored";
    expect_old_or_new(files_below(outputs_folder()), output);
    EXPECT_EQ(run().code, 0);
    EXPECT_EQ(difference(files_below(outputs_folder()), after()), "");
    restore_files(outputs_folder(), before());
  }
  EXPECT_TRUE(was_set_aside) << "no kill fell between the two renames";
}

INSTANTIATE_TEST_SUITE_P(OfAFolder, FaultsWithoutExchange,
                         ::testing::Values(Writer{
                             "masks", "masks in/result in/sweep -o new/masks", {"masks"}}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace symscene::testing
