#pragma once

#include <algorithm>
#include <map>
#include <memory>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {

/// A small scene and its result, shared by all tests.
class Command : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    workspace_ = std::make_unique<Workspace>();
    write(*workspace_ / "small.json", R"({
      "tabletop": {"objects": 2},
      "camera": {"frames": 8}  // few
    })");
    const Outcome simulated = run("simulate -o scene --config small.json");
    ASSERT_EQ(simulated.code, 0) << simulated.err;
    const Outcome segmented = run("segment scene -o result");
    ASSERT_EQ(segmented.code, 0) << segmented.err;
    ASSERT_FALSE(objects_without_times("result").at("objects").empty());
  }
  static void TearDownTestSuite() { workspace_.reset(); }

  static Outcome run(const std::string& arguments, const fs::path& output = {}) {
    return workspace_->run(arguments, output);
  }
  static fs::path file(const std::string& name) { return *workspace_ / name; }

  /// Every file under the workspace and its bytes.
  static std::map<std::string, std::string> snapshot() {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(workspace_->folder())) {
      files[entry.path().string()] = entry.is_regular_file() ? contents(entry.path()) : "";
    }
    return files;
  }

  /// One sentence on standard error, nothing on standard output, nothing changed on disk.
  static void expect_refusal(const std::string& arguments, int code, const std::string& sentence) {
    const auto before = snapshot();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("symscene")) << outcome.err;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << arguments << "\n" << outcome.err;
    EXPECT_EQ(snapshot(), before) << arguments;
  }

  /// The last line of the output, as JSON.
  static nlohmann::json last_line(const std::string& out) {
    const std::size_t end = out.find_last_not_of('\n');
    const std::size_t newline = out.rfind('\n', end);
    return nlohmann::json::parse(out.substr(newline == std::string::npos ? 0 : newline + 1));
  }

  /// objects.json without the times and what made it.
  static nlohmann::json objects_without_times(const std::string& result) {
    nlohmann::json objects = nlohmann::json::parse(contents(file(result) / "objects.json"));
    objects.erase("timings");
    objects.erase("made_by");
    return objects;
  }

 private:
  static inline std::unique_ptr<Workspace> workspace_;
};

/// A PNG of 4×2 pixels of 16-bit grey: 1000 to 1006, and one 0.
inline const std::string depth_png(
    "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\004\000\000"
    "\000\002\020\000\000\000\000\012\123\376\374\000\000\000\033\111\104\101\124\170\234\143"
    "\140\176\301\374\222\371\025\363\153\006\346\067\314\157\231\337\061\060\000\000\076\063"
    "\006\203\107\104\141\004\000\000\000\000\111\105\116\104\256\102\140\202",
    84);

}  // namespace symscene::testing
