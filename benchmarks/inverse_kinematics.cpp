// Inverse kinematics of the included robots: share of random reachable poses that are solved, and
// time per pose.
#include <benchmark/benchmark.h>

#include "core/median.hpp"
#include "core/random.hpp"
#include "stopwatch.hpp"
#include "symscene/io/robot.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace {

using namespace symscene;

constexpr int pose_count = 2000;

/// Poses of the tip at positions that are uniform within the limits.
std::vector<Eigen::Isometry3d> reachable_poses(const ArmChain& chain) {
  Random random(2000);
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < pose_count; ++i) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(chain.joints.size()));
    for (std::size_t k = 0; k < chain.joints.size(); ++k)
      q[static_cast<Eigen::Index>(k)] =
          random.uniform(chain.joints[k].lower, chain.joints[k].upper);
    poses.push_back(tip_pose(chain, q));
  }
  return poses;
}

void solve_poses(benchmark::State& state, const char* name, const char* arm) {
  const Robot robot = read_robot(name);
  const ArmChain chain = arm_chain(robot.model, robot.arm(arm).arm);
  const std::vector<Eigen::Isometry3d> poses = reachable_poses(chain);
  std::vector<double> milliseconds;
  int solved = 0;
  for (auto _ : state) {
    for (const Eigen::Isometry3d& T_base_tip : poses) {
      InverseKinematicsResult result;
      const Seconds time = seconds([&] { result = inverse_kinematics(chain, T_base_tip); });
      milliseconds.push_back(1e3 * time.wall);
      solved += result.converged() ? 1 : 0;
    }
  }
  state.counters["solved_percent"] = 100.0 * solved / static_cast<double>(milliseconds.size());
  state.counters["median_ms"] = quantile(milliseconds, 0.5).value_or(0.0);
  state.counters["p95_ms"] = quantile(milliseconds, 0.95).value_or(0.0);
}

BENCHMARK_CAPTURE(solve_poses, panda, "panda", "arm")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_poses, baxter_right, "baxter", "right")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_poses, baxter_left, "baxter", "left")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
