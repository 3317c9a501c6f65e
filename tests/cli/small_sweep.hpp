#pragma once

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {

/// A small simulated sweep, one whose camera measures nothing, and the scene of the first.
class SweepCommand : public ::testing::Test {
 protected:
  static constexpr int frames = 12;

  static void SetUpTestSuite() {
    workspace_ = std::make_unique<Workspace>();
    const std::string camera = R"("tabletop": {"objects": 7}, "camera": {"frames": 12, "arc": 0.09,
      "radius": 0.7, "width": 320, "height": 240, "focal_length": 262})";
    write(*workspace_ / "sweep.json", "{" + camera + "}");
    write(*workspace_ / "dark.json", "{" + camera + R"(, "sensor": {"max_depth": 0.05}})");
    for (const char* name : {"sweep", "dark"}) {
      const std::string line = std::string("simulate --sequence -o ") + name + " --config " + name;
      const Outcome simulated = run(line + ".json");
      ASSERT_EQ(simulated.code, 0) << simulated.err;
    }
    const Outcome reconstructed = run("reconstruct sweep -o scene --json");
    ASSERT_EQ(reconstructed.code, 0) << reconstructed.err;
    report_ = reconstructed.err + reconstructed.out;
  }
  static void TearDownTestSuite() { workspace_.reset(); }

  static Outcome run(const std::string& arguments) { return workspace_->run(arguments); }
  static fs::path file(const std::string& name) { return *workspace_ / name; }
  static const std::string& report() { return report_; }

  /// The table of the scene as the value of --plane.
  static std::string given_plane() {
    const std::string found = contents(file("scene") / "table_plane.txt");
    std::string plane = found.substr(0, found.find_last_not_of('\n') + 1);
    std::replace(plane.begin(), plane.end(), '\n', ',');
    return plane;
  }

  /// A copy of the sweep to modify.
  static fs::path copy_of_sweep(const std::string& name) {
    fs::remove_all(file(name));
    fs::copy(file("sweep"), file(name), fs::copy_options::recursive);
    return file(name);
  }

  /// A copy of its first frame, without the pose.
  static void copy_of_first_frame(const std::string& name) {
    const fs::path copy = copy_of_sweep(name);
    for (int i = 1; i < frames; ++i) fs::remove(copy / image(i));
    fs::remove(copy / "poses.txt");
  }

  static std::string image(int i) {
    const std::string number = std::to_string(i);
    return "depth/" + std::string(6 - number.size(), '0') + number + ".png";
  }

  static nlohmann::json frames_of(const std::string& scene) {
    return nlohmann::json::parse(contents(file(scene) / "scene.json")).at("frames");
  }

  static auto poses_of(const std::string& scene) {
    const std::string text = contents(file(scene) / "poses.txt");
    std::size_t poses = 0, begin = 0;
    while (begin < text.size()) {
      poses += text[begin] != '#' && text[begin] != '\n' ? 1 : 0;
      begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
    }
    return poses;
  }

  /// Checks exit code and message, and that nothing was written.
  static void expect_failure(const std::string& arguments, int code, const std::string& sentence) {
    const Outcome outcome = run("reconstruct " + arguments);
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.err.find("found  "), std::string::npos) << outcome.err;
    for (const auto& entry : fs::directory_iterator(workspace_->folder())) {
      EXPECT_EQ(entry.path().filename().string().find("new"), std::string::npos) << entry.path();
    }
  }

 private:
  static inline std::unique_ptr<Workspace> workspace_;
  static inline std::string report_;
};

}  // namespace symscene::testing
