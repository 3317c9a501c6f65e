// Every command that writes, with one failing call of the C library after the other, and killed at
// each call that changes files. SYMSCENE_FAULT_SECONDS: so long are failing allocations tried per
// command; without it a sample is.
#include "faults/faults.hpp"

#include <chrono>
#include <cstdio>
#include <set>

namespace symscene::testing {
namespace {

/// Allocations per command that the short run lets fail.
constexpr std::uint64_t few_allocations = 2;

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

INSTANTIATE_TEST_SUITE_P(OfEveryWriter, Faults, ::testing::ValuesIn(writers()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace symscene::testing
