// Options of --config from outside: their documentation, and files with values out of range.
#include <gtest/gtest.h>

#include "cli/command.hpp"

namespace symscene::testing {
namespace {

TEST(OptionsCommand, PrintsThePageInTheDocumentation) {
  const Workspace workspace;
  const Outcome printed = workspace.run("options");
  ASSERT_EQ(printed.code, 0) << printed.err;
  const bool up_to_date =
      printed.out == contents(fs::path(SYMSCENE_SOURCE_DIR) / "docs/options.md");
  EXPECT_TRUE(up_to_date)
      << "docs/options.md is out of date: run build/bin/symscene options > docs/options.md";
}

TEST(OptionsCommand, ListsEachOptionOfADumpedConfigurationWithItsUnit) {
  const Workspace workspace;
  const Outcome printed = workspace.run("options");
  EXPECT_NE(printed.out.find("## `symscene segment`\n"), std::string::npos);
  EXPECT_NE(printed.out.find("\n| `voxel_size` | 0.005 | m |"), std::string::npos);
  EXPECT_NE(printed.out.find("## `symscene evaluate`\nThe options of `symscene segment`."),
            std::string::npos);
}

TEST(OptionsCommand, NamesFileAndOptionWhereOptionsContradictEachOther) {
  const Workspace workspace;
  write(workspace / "few.json", R"({"min_objects": 9, "max_objects": 3})");
  const Outcome outcome = workspace.run("dataset new --config few.json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("max_objects (with the options of few.json): expected"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(fs::exists(workspace / "new"));
}

}  // namespace
}  // namespace symscene::testing
