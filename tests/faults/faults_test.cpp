// Every command that writes, with one failing call of the C library after the other, and killed at
// each call that changes files. SYMSCENE_FAULT_SECONDS: so long are failing allocations tried per
// command; without it a sample is.
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "faults/faulty_run.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene::testing {
namespace {

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

/// Allocations per command that the short run lets fail.
constexpr std::uint64_t few_allocations = 2;

/// A command that writes.
struct Writer {
  std::string name;
  std::string line;
  std::vector<std::string> outputs;  ///< each is written as a whole, or not at all
  bool replaces = true;              ///< it replaces older outputs
  bool quick = true;                 ///< a run takes less than half a second
};

std::ostream& operator<<(std::ostream& stream, const Writer& writer) {
  return stream << writer.line;
}

const std::vector<Writer>& writers() {
  static const std::vector<Writer> all = {
      {"simulate", "simulate -o new/scene --config in/table.json", {"scene"}},
      {"sweep", "simulate --sequence -o new/sweep --config in/sweep.json", {"sweep"}},
      {"reconstruct",
       "reconstruct in/sweep --poses exact -o new/scene --config in/coarse.json",
       {"scene"}},
      {"stitch", "stitch in/photos -o new/scene --config in/coarse.json", {"scene"}},
      {"segment", "segment in/scene -o new/result --page new/page.html", {"result", "page.html"}},
      {"masks", "masks in/result in/sweep -o new/masks", {"masks"}},
      {"view", "view in/result -o new/page.html", {"page.html"}},
      {"export", "export in/result -o new/result.mcap", {"result.mcap"}},
      {"grasp",
       "grasp in/result --scene in/scene -o new/g.json --page new/g.html --config in/grasp.json",
       {"g.json", "g.html"}},
      {"plan",
       "plan in/grasps.json --result in/result --scene in/scene -o new/plan.json "
       "--moveit new/moveit.json --grasping-msgs new/msgs.json --config in/plan.json",
       {"plan.json", "moveit.json", "msgs.json"}},
      {"cylinders", "cylinders in/scene -o new/c.json --page new/c.html", {"c.json", "c.html"}},
      {"next_view",
       "next-view in/result --scene in/scene --camera in/sweep/intrinsics.txt -o new/v.json "
       "--page new/v.html",
       {"v.json", "v.html"}},
      {"symmetry", "symmetry in/scene/cloud.ply --partial -o new/s.json", {"s.json"}},
      {"calibrate",
       "calibrate depth in/walls --wall -o new/camera.yaml --page new/page.html",
       {"camera.yaml", "page.html"}},
      {"dataset",
       "dataset new/data --scenes 1 --config in/dataset.json",
       {"data/dataset.json", "data/scenes/0000"},
       false},
      {"evaluate", "evaluate in/data -o new/report --fast --baselines none", {"report"}},
      {"explore", "explore --simulate --count 1 --views 1 -o new/run", {"run"}, true, false},
      {"pick",
       "pick --simulate --count 1 --seed 3 -o new/run --config in/pick.json",
       {"run"},
       true,
       false},
  };
  return all;
}

/// Walls at several distances.
void write_walls(const fs::path& folder) {
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

double seconds_for_allocations() {
  const char* text = std::getenv("SYMSCENE_FAULT_SECONDS");
  return text == nullptr ? 0.0 : std::atof(text);
}

/// Numbers from 1 to `count`, each once, so that any beginning is spread over all of them.
std::vector<std::uint64_t> spread_numbers(std::uint64_t count) {
  auto step = static_cast<std::uint64_t>(0.6180339887 * static_cast<double>(count)) + 1;
  while (std::gcd(step, count) != 1) ++step;
  std::vector<std::uint64_t> numbers(count);
  for (std::uint64_t i = 0; i < count; ++i) numbers[i] = 1 + (i + 1) * step % count;
  return numbers;
}

/// Every call; in the short run `few` of them, the last among them, which commits.
std::vector<std::uint64_t> chosen_calls(std::uint64_t count, std::size_t few) {
  std::vector<std::uint64_t> calls = spread_numbers(count);
  if (seconds_for_allocations() <= 0.0 && calls.size() > few) {
    calls.resize(few);
    if (std::find(calls.begin(), calls.end(), count) == calls.end()) calls.back() = count;
  }
  return calls;
}

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

TEST_P(Faults, LeaveOutputsWholeOrAbsent) {
  check_each({Kind::open, Kind::read, Kind::write, Kind::close, Kind::sync, Kind::mkdir}, 1);
  check_each({Kind::rename}, 2);
  check_kills(1);
  const FaultyRun last = run();
  EXPECT_EQ(last.code, 0) << last.err;
  EXPECT_EQ(difference(files_below(outputs_folder()), after()), "");
}

TEST_P(Faults, LeaveOlderOutputsUntilTheyAreReplaced) {
  if (!GetParam().replaces) GTEST_SKIP() << "continues older outputs";
  const std::set<std::string> short_run{"simulate", "segment", "view"};  // a folder, both, a file
  if (short_run.count(GetParam().name) == 0 && seconds_for_allocations() <= 0.0)
    GTEST_SKIP() << "replaces as others do";
  begin_with(older_outputs());
  check_each({Kind::rename}, 2);
  check_kills(2);
}

TEST_P(Faults, OfMemoryEndInASentence) {
  const double seconds = seconds_for_allocations();
  const auto begin = std::chrono::steady_clock::now();
  std::uint64_t tried = 0;
  for (const std::uint64_t call : spread_numbers(count(Kind::allocation))) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    if (HasFailure() || (seconds > 0.0 ? taken.count() > seconds : tried == few_allocations)) break;
    check_fault(Kind::allocation, call);
    ++tried;
  }
  if (seconds > 0.0)
    std::printf("faults: %s: %llu of %llu allocations\n", GetParam().name.c_str(),
                static_cast<unsigned long long>(tried),
                static_cast<unsigned long long>(count(Kind::allocation)));
}

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

INSTANTIATE_TEST_SUITE_P(OfEveryWriter, Faults, ::testing::ValuesIn(writers()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace symscene::testing
