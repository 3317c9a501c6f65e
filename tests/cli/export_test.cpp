// `symscene export`, run as a process. tests/recordings reads what it writes.
#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

TEST_F(Command, ExportsAResultAsMcap) {
  const Outcome exported = run("export result -o result.mcap --json");
  ASSERT_EQ(exported.code, 0) << exported.err;
  const std::string bytes = contents(file("result.mcap"));
  EXPECT_TRUE(bytes.starts_with("\x89MCAP0\r\n"));
  EXPECT_EQ(last_line(exported.out).at("bytes"), bytes.size());
  EXPECT_EQ(run("export result -o again.mcap").code, 0);
  EXPECT_EQ(contents(file("again.mcap")), bytes);
}

TEST_F(Command, RefusesToExportWhatIsNeitherResultNorSequence) {
  const Outcome scene = run("export scene -o scene.mcap");
  EXPECT_EQ(scene.code, 1);
  EXPECT_NE(scene.err.find("expected a result folder or a sequence of depth images, found neither"),
            std::string::npos)
      << scene.err;
  EXPECT_FALSE(fs::exists(file("scene.mcap")));
  EXPECT_EQ(run("export result -o result.json").code, 2);
  const Outcome scaled = run("export result -o result.mcap --depth-scale 1000");
  EXPECT_NE(scaled.code, 0);
  EXPECT_NE(scaled.err.find("--depth-scale"), std::string::npos) << scaled.err;
  EXPECT_EQ(run("export result -o result.mcap --compression gzip").code, 2);
}

}  // namespace
}  // namespace symscene::testing
