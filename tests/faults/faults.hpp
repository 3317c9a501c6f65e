#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "faults/faulty_run.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene::testing {

namespace fs = std::filesystem;

constexpr const char* table_config = R"({"tabletop": {"objects": 1}, "min_object_points": 20,
  "camera": {"frames": 3, "width": 96, "height": 72, "focal_length": 80, "radius": 0.5,
  "arc": 0.3}, "cloud": {"voxel_size": 0.006, "min_frames": 1}, "occupancy": {"resolution": 0.02}})";
constexpr const char* sweep_config = R"({"tabletop": {"objects": 1}, "camera": {"frames": 2,
  "width": 96, "height": 72, "focal_length": 80, "radius": 0.5, "arc": 0.05}})";
constexpr const char* photos_config = R"({"tabletop": {"objects": 8}, "camera": {"frames": 2,
  "width": 240, "height": 180, "focal_length": 200, "radius": 0.5, "arc": 0.1}})";
constexpr const char* coarse_config = R"({"tsdf": {"voxel_size": 0.02, "truncation": 0.06,
  "max_truncation": 0.1}, "occupancy": {"resolution": 0.02}})";
constexpr const char* grasp_config = R"({"max_rejected": 1})";
constexpr const char* plan_config = R"({"pick": {"rrt": {"shortcuts": 2}}})";
constexpr const char* dataset_config = R"({"min_objects": 3, "max_objects": 3, "arranged_every": 1,
  "max_error": 1.0, "max_table_error": 1.0, "attempts": 3,
  "camera": {"frames": 3, "arc": 0.005, "radius": 0.5, "width": 160, "height": 120,
  "focal_length": 130}, "shake": {"translation": 0, "rotation": 0}, "making": {"reconstruction": {
  "tsdf": {"voxel_size": 0.01, "truncation": 0.03, "max_truncation": 0.05},
  "occupancy": {"resolution": 0.02}, "tracking": {"min_overlap": 0.05, "min_inliers": 0.05,
  "min_measured": 0.001, "min_matches": 10, "degenerate_ratio": 1e-9, "max_disagreement": 0.1}}}})";
constexpr const char* pick_config = R"({"max_looks": 1, "empty_looks": 1,
  "look": {"frames": 3, "width": 96, "height": 72, "focal_length": 70}})";

/// A command that writes.
struct Writer {
  std::string name;
  std::string line;
  std::vector<std::string> outputs;  ///< each is written as a whole, or not at all
  bool replaces = true;              ///< it replaces older outputs
  bool quick = true;                 ///< a run takes less than half a second
};

inline std::ostream& operator<<(std::ostream& stream, const Writer& writer) {
  return stream << writer.line;
}

/// Walls at several distances.
inline void write_walls(const fs::path& folder) {
  const CameraIntrinsics camera{40, 30, 33.0, 33.0, 19.5, 14.5};
  SequenceWriter writer(folder, camera);
  for (int i = 0; i < 6; ++i) {
    DepthFrame frame;
    frame.time = i;
    frame.depth.assign(40 * 30, 0.6F + 0.25F * static_cast<float>(i));
    writer.add(frame);
  }
  writer.finish();
}

inline double seconds_for_allocations() {
  const char* text = std::getenv("SYMSCENE_FAULT_SECONDS");
  return text == nullptr ? 0.0 : std::atof(text);
}

/// Numbers from 1 to `count`, each once, so that any beginning is spread over all of them.
inline std::vector<std::uint64_t> spread_numbers(std::uint64_t count) {
  auto step = static_cast<std::uint64_t>(0.6180339887 * static_cast<double>(count)) + 1;
  while (std::gcd(step, count) != 1) ++step;
  std::vector<std::uint64_t> numbers(count);
  for (std::uint64_t i = 0; i < count; ++i) numbers[i] = 1 + (i + 1) * step % count;
  return numbers;
}

/// Every call; in the short run `few` of them, the last among them, which commits.
inline std::vector<std::uint64_t> chosen_calls(std::uint64_t count, std::size_t few) {
  std::vector<std::uint64_t> calls = spread_numbers(count);
  if (seconds_for_allocations() <= 0.0 && calls.size() > few) {
    calls.resize(few);
    if (std::find(calls.begin(), calls.end(), count) == calls.end()) calls.back() = count;
  }
  return calls;
}

/// Runs of a command with its inputs, one for all tests, and with older outputs or none. Without
/// SYMSCENE_FAULT_SECONDS a sample of the calls fails.
class Faults : public ::testing::TestWithParam<Writer> {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::temp_directory_path() / ("symscene-faults-" + std::to_string(getpid()));
    fs::create_directories(folder_ / "in" / "data");
    for (const auto& [name, text] : {std::pair{"table", table_config},
                                     {"sweep", sweep_config},
                                     {"photos", photos_config},
                                     {"coarse", coarse_config},
                                     {"grasp", grasp_config},
                                     {"plan", plan_config},
                                     {"dataset", dataset_config},
                                     {"pick", pick_config}})
      std::ofstream(folder_ / "in" / (std::string(name) + ".json")) << text;
    write_walls(folder_ / "in" / "walls");
    for (const char* line :
         {"simulate -o in/scene --config in/table.json",
          "simulate --sequence -o in/sweep --config in/sweep.json",
          "simulate --sequence -o in/photos --config in/photos.json",
          "segment in/scene -o in/result",
          "grasp in/result --scene in/scene -o in/grasps.json --config in/grasp.json",
          "simulate -o in/data/one --config in/table.json"}) {
      const FaultyRun run = run_with_fault(folder_, line + std::string(" --quiet"));
      ASSERT_EQ(run.code, 0) << line << "\n" << run.err;
    }
  }
  static void TearDownTestSuite() {
    fs::remove_all(folder_);
    fs::remove_all(folder_.string() + ".streams");
  }

  void SetUp() override {
    if (!GetParam().quick && seconds_for_allocations() <= 0.0) GTEST_SKIP() << "takes long";
    begin_with({});
  }

  static fs::path outputs_folder() { return folder_ / "new"; }

  static FaultyRun run(Kind kind = Kind::open, std::uint64_t call = 0) {
    std::string line = GetParam().line + " --quiet";
    if (GetParam().name != "view" && GetParam().name != "export") line += " --threads 1";
    return run_with_fault(folder_, line, kind, call);
  }

  /// The parts of `files` that belong to an output.
  static Files part_of(const Files& files, const std::string& output) {
    Files part;
    for (const auto& [name, bytes] : files)
      if (name == output || name.starts_with(output + "/")) part[name] = bytes;
    return part;
  }

  /// Names of what two folders do not share.
  static std::string difference(const Files& a, const Files& b) {
    std::string names;
    for (const auto& [name, bytes] : a)
      if (b.count(name) == 0 || b.at(name) != bytes) names += name + " ";
    for (const auto& [name, bytes] : b)
      if (a.count(name) == 0) names += name + " ";
    return names;
  }

  /// Begins with `before` in the place of the outputs, and counts calls in a run that nothing
  /// disturbs.
  void begin_with(const Files& before) {
    before_ = before;
    restore_files(outputs_folder(), before_);
    const FaultyRun undisturbed = run();
    if (undisturbed.err.find("-dev") != std::string::npos) GTEST_SKIP() << undisturbed.err;
    ASSERT_EQ(undisturbed.code, 0) << undisturbed.err;
    counts_ = undisturbed.counts;
    after_ = files_below(outputs_folder());
    restore_files(outputs_folder(), before_);
  }

  /// Every output is as before or as after; what else was written is staging.
  void expect_whole_outputs(const Files& files) const {
    std::size_t belonging = 0;
    for (const std::string& output : GetParam().outputs) {
      const Files part = part_of(files, output);
      belonging += part.size();
      EXPECT_TRUE(part == part_of(before_, output) || part == part_of(after_, output))
          << output << " is partly written";
    }
    std::size_t others = 0;
    for (const auto& [name, bytes] : files) {
      const bool parent = name.back() == '/' && after_.count(name) != 0;
      others += parent || name.find(".tmp-") != std::string::npos ? 0 : 1;
    }
    EXPECT_LE(others, belonging) << "files beside the outputs";
  }

  static void expect_no_staging(const Files& files) {
    for (const auto& [name, bytes] : files)
      EXPECT_EQ(name.find(".tmp-"), std::string::npos) << name;
  }

  /// One sentence, and warnings.
  static void expect_sentence(const std::string& err) {
    std::istringstream lines(err);
    int sentences = 0;
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(line.starts_with("symscene")) << err;
      sentences += line.find(": warning: ") == std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(sentences, 1) << err;
    EXPECT_EQ(err.find("internal error"), std::string::npos) << err;
  }

  /// Destructors of nlohmann::basic_json allocate and may not throw: where that allocation fails
  /// the library ends the process.
  static bool ended_in_destructor(const FaultyRun& faulty) {
    return faulty.signal == SIGABRT &&
           faulty.err ==
               "terminate called after throwing an instance of 'std::bad_alloc'\n"
               "  what():  std::bad_alloc\n";
  }

  void check_fault(Kind kind, std::uint64_t call) {
    SCOPED_TRACE(std::string(kinds[static_cast<std::size_t>(kind)]) + " " + std::to_string(call));
    const FaultyRun faulty = run(kind, call);
    if (kind == Kind::allocation && ended_in_destructor(faulty)) {
      expect_whole_outputs(files_below(outputs_folder()));
      restore_files(outputs_folder(), before_);
      return;
    }
    EXPECT_EQ(faulty.signal, 0) << faulty.err;
    const Files files = files_below(outputs_folder());
    expect_no_staging(files);
    const bool warned = faulty.err.find(": warning: ") != std::string::npos;
    if (faulty.code == 0 && !warned) {
      EXPECT_EQ(difference(files, after_), "") << "neither harmless nor told";
    }
    if (faulty.code != 0 || !warned) expect_whole_outputs(files);
    if (faulty.code != 0) expect_sentence(faulty.err);
    if (files != before_) restore_files(outputs_folder(), before_);
  }

  void check_kill(std::uint64_t call) {
    SCOPED_TRACE("kill " + std::to_string(call));
    EXPECT_NE(run(Kind::kill, call).code, 0);
    expect_whole_outputs(files_below(outputs_folder()));
    const FaultyRun next = run();
    EXPECT_EQ(next.code, 0) << next.err;
    EXPECT_EQ(difference(files_below(outputs_folder()), after_), "");
    restore_files(outputs_folder(), before_);
  }

  void check_each(std::initializer_list<Kind> checked, std::size_t few) {
    for (const Kind kind : checked)
      for (const std::uint64_t call : chosen_calls(count(kind), few)) check_fault(kind, call);
  }

  std::uint64_t count(Kind kind) const { return counts_[static_cast<std::size_t>(kind)]; }

  void check_kills(std::size_t few) {
    for (const std::uint64_t call : chosen_calls(count(Kind::kill), few)) check_kill(call);
  }

  /// What stood there before: the outputs of another run.
  Files older_outputs() const {
    Files older = after_;
    for (auto& [name, bytes] : older)
      if (name.back() != '/') bytes += "\n";
    return older;
  }

  const Files& before() const { return before_; }
  const Files& after() const { return after_; }

 private:
  static inline fs::path folder_;
  Files before_;
  Files after_;
  CallCounts counts_{};
};

}  // namespace symscene::testing
