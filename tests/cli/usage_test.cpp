// The command line itself: mistakes and their exit codes, help, and options that all subcommands
// share.
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {
namespace {

class Usage : public ::testing::Test {
 protected:
  Outcome run(const std::string& arguments) const { return workspace_.run(arguments); }

  /// Exit code 2, one sentence on standard error and nothing else.
  void expect_mistake(const std::string& arguments, const std::string& sentence) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
  }

  Workspace workspace_;
};

TEST_F(Usage, NamesTheNearestSubcommandAndOption) {
  const std::vector<std::pair<const char*, const char*>> cases = {
      {"segmnt scene -o x", "found \"segmnt\" (did you mean \"segment\"?)"},
      {"help segmnt", "found \"segmnt\" (did you mean \"segment\"?)"},
      {"calibrate dept", "found \"dept\" (did you mean \"depth\"?)"},
      {"segment scene --output2 x", "found \"--output2\" (did you mean \"--output\"?)"},
      {"segment scene -o x --thraeds 3", "found \"--thraeds\" (did you mean \"--threads\"?)"},
      {"segment scene -o x --thraeds=3", "found \"--thraeds\" (did you mean \"--threads\"?)"},
      {"--quite segment scene -o x", "found \"--quite\" (did you mean \"--quiet\"?)"},
      {"view result -o x --threads 2", "expected an option of symscene view, found \"--threads\""},
      {"segment scene more -o x", "expected no further argument, found \"more\""}};
  for (const auto& [arguments, sentence] : cases) expect_mistake(arguments, sentence);
}

TEST_F(Usage, NamesWhatIsMissing) {
  expect_mistake("", "expected a subcommand, found none (see symscene --help)");
  expect_mistake("calibrate", "expected a subcommand, found none (see symscene calibrate --help)");
  expect_mistake("view result", "expected --output FILE (page to write), found none");
  expect_mistake("view -o x", "expected RESULT (result folder), found none");
  expect_mistake("view result -o", "--output: expected a value, found none");
}

TEST_F(Usage, ExitsWithTwoForWrongValuesAndNamesOptionExpectedAndFound) {
  const std::vector<std::pair<const char*, const char*>> cases = {
      {"segment scene -o x --plane 1,2,3", "--plane: expected four numbers"},
      {"segment scene -o x --reflectional curves",
       "--reflectional: expected one of curve, surface, both, found \"curves\" (did you mean "
       "\"curve\"?)"},
      {"segment scene -o x --depth-scale big", "--depth-scale: expected a number in"},
      {"segment scene -o x --threads -1", "--threads: expected a whole number in [0, 4096]"},
      {"segment scene -o a -o b", "--output: expected the option once, found it 2 times"},
      {"segment scene -o x --quiet=3", "--quiet: expected no value, found one"},
      {"segment scene -o x --any-up --no-table", "--any-up: expected no --no-table beside it"},
      {"segment --dump-config=long", "--dump-config: expected nothing or annotated, found long"},
      {"grasp result -o x --gripper claw", "--gripper: expected"}};
  for (const auto& [arguments, sentence] : cases) expect_mistake(arguments, sentence);
}

TEST_F(Usage, HelpIsASubcommandToo) {
  EXPECT_EQ(run("help").out, run("--help").out);
  EXPECT_EQ(run("help segment").out, run("segment --help").out);
  EXPECT_EQ(run("help calibrate depth").out, run("calibrate depth --help").out);
  EXPECT_NE(run("help calibrate depth").out.find("Usage: symscene calibrate depth"),
            std::string::npos);
}

TEST_F(Usage, HelpSaysOfWhatKindEveryValueIs) {
  const std::string all = run("--help").out;
  const std::size_t list = all.find("Subcommands:");
  ASSERT_NE(list, std::string::npos);
  std::istringstream lines(all.substr(list, all.find("Example:") - list));
  std::string line;
  std::size_t commands = 0;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    if (line.size() < 3 || line[2] == ' ') continue;
    const std::string help = run("help " + line.substr(2, line.find(' ', 2) - 2)).out;
    ++commands;
    for (const char* vague : {" TEXT", " N ", " OUT", " UINT", " INT", " FLOAT"})
      EXPECT_EQ(help.find(vague), std::string::npos) << help;
  }
  EXPECT_GE(commands, 13U);
}

TEST_F(Usage, DumpsPlainJsonAndCommentsOnlyOnRequest) {
  const Outcome plain = run("segment --dump-config");
  ASSERT_EQ(plain.code, 0) << plain.err;
  const auto values = nlohmann::json::parse(plain.out);  // refuses comments
  const Outcome annotated = run("segment --dump-config=annotated");
  EXPECT_NE(annotated.out.find("  // "), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(annotated.out, nullptr, true, true), values);
  write(workspace_ / "annotated.json", annotated.out);
  EXPECT_EQ(run("segment --dump-config --config annotated.json").out, plain.out);
}

TEST_F(Usage, OptionsOfAllSubcommandsMayStandBeforeThem) {
  const Outcome plain = run("info nowhere --json -v -q");
  for (const char* line :
       {"--json -v -q info nowhere", "-q info nowhere", "-qv info nowhere",
        "--threads 2 --quiet segment nowhere -o x", "--threads=2 segment nowhere -o x",
        "--threads 2 calibrate depth nowhere --wall -o x"}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.code, plain.code) << line << outcome.err;
    EXPECT_NE(outcome.err.find("nowhere"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run("--version segment").out, run("--version").out);
  EXPECT_EQ(run("--help segment").out, run("segment --help").out);
  expect_mistake("--threads many segment nowhere -o x", "--threads: expected a whole number");
  expect_mistake("--threads 2 view nowhere -o x", "found \"--threads\"");
}

/// What bash offers for the last word of a line, a line each.
std::string offered(const Workspace& workspace, const std::string& words) {
  write(workspace / "ask.sh", "source completion.bash\nCOMP_WORDS=(" + words +
                                  ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_symscene\n"
                                  "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
  const std::string line = "cd '" + workspace.folder().string() + "' && bash ask.sh > offered";
  EXPECT_EQ(std::system(line.c_str()), 0);
  return contents(workspace / "offered");
}

TEST_F(Usage, BashCompletesSubcommandsOptionsAndValues) {
  if (std::system("command -v bash > /dev/null") != 0) GTEST_SKIP() << "bash is not installed";
  ASSERT_EQ(run("completion bash -o completion.bash").code, 0);
  EXPECT_EQ(contents(workspace_ / "completion.bash"), run("completion bash").out);
  write(workspace_ / "camera.yaml", "");
  fs::create_directory(workspace_ / "camera_images");
  EXPECT_EQ(offered(workspace_, "symscene segm"), "segment\n");
  EXPECT_EQ(offered(workspace_, "symscene calibrate d"), "depth\n");
  EXPECT_EQ(offered(workspace_, "symscene --threads 2 calibrate depth --squ"), "--square\n");
  EXPECT_EQ(offered(workspace_, "symscene segment scene --reflectional cu"), "curve\n");
  EXPECT_EQ(offered(workspace_, "symscene segment scene --threads ''"), "\n");
  const std::string files = offered(workspace_, "symscene segment cam");
  for (const char* file : {"camera.yaml", "camera_images"})
    EXPECT_NE(files.find(file), std::string::npos) << files;
  EXPECT_EQ(offered(workspace_, "symscene segment scene -o cam"), "camera_images\n");
  write(workspace_ / "table scan.png", "");
  EXPECT_EQ(offered(workspace_, "symscene segment tabl"), "table scan.png\n");
  EXPECT_EQ(offered(workspace_, "symscene help recon"), "reconstruct\n");
  EXPECT_EQ(offered(workspace_, "symscene completion z"), "zsh\n");
  expect_mistake("completion fish", "SHELL: expected one of bash, zsh, found \"fish\"");
}

TEST_F(Usage, ZshCompletesWhatBashDoes) {
  const std::string script = run("completion zsh").out;
  EXPECT_TRUE(script.starts_with("#compdef symscene\n"));
  for (const char* line : {"\"symscene segment --reflectional\") compadd -- curve surface both",
                           "\"symscene segment -o\"|\"symscene segment --output\") _files -/",
                           "\"symscene view -o\"|\"symscene view --output\") _files;"})
    EXPECT_NE(script.find(line), std::string::npos) << line;
}

TEST_F(Usage, TheManualHasEverySubcommandAndOption) {
  const Outcome manual = run("manual");
  ASSERT_EQ(manual.code, 0);
  for (const char* part :
       {".TH SYMSCENE 1", ".SS symscene segment\n", ".SS symscene calibrate depth\n",
        "\\fB\\-o, \\-\\-output\\fR \\fIFOLDER\\fR", ".SH EXIT STATUS"})
    EXPECT_NE(manual.out.find(part), std::string::npos) << part;
}

TEST_F(Usage, JsonIsAllThatStandardOutputGets) {
  write(workspace_ / "cloud.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nend_header\n0 0 0\n0 0 1\n0 1 0\n");
  const Outcome people = run("info cloud.ply");
  const Outcome both = run("-v --json info cloud.ply");
  ASSERT_EQ(both.code, 0) << both.err;
  EXPECT_EQ(nlohmann::json::parse(both.out).at("command"), "info");
  EXPECT_NE(both.err.find(people.out), std::string::npos) << both.err;
  EXPECT_NE(both.err.find("total"), std::string::npos) << both.err;
  const Outcome quiet = run("--json -q info cloud.ply");
  EXPECT_EQ(nlohmann::json::parse(quiet.out).at("command"), "info");
  EXPECT_EQ(quiet.err, "");
}

}  // namespace
}  // namespace symscene::testing
