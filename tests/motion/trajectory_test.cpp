#include "symscene/motion/trajectory.hpp"

#include <gtest/gtest.h>

#include "fastest_bound.hpp"
#include "random_paths.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using testing::random_path;
using testing::RandomPath;

#ifdef SYMSCENE_SANITIZED
constexpr int paths = 30;
#else
constexpr int paths = 300;
#endif

Eigen::VectorXd vector(std::initializer_list<double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.begin(),
                                           static_cast<Eigen::Index>(values.size()));
}

TimedPath trajectory_of(const RandomPath& path, double max_deviation = 0.1) {
  TrajectoryOptions options;
  options.max_deviation = max_deviation;
  return time_optimal_trajectory(path.waypoints, path.limits, options);
}

double distance_from_segment(const Eigen::VectorXd& p, const Eigen::VectorXd& a,
                             const Eigen::VectorXd& b) {
  const double squared = (b - a).squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
  return (p - a - share * (b - a)).norm();
}

double distance_from_path(const Eigen::VectorXd& p, const std::vector<Eigen::VectorXd>& path) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    least = std::min(least, distance_from_segment(p, path[i], path[i + 1]));
  return least;
}

/// The greatest |value| / limit over the joints.
double greatest_share(const Eigen::VectorXd& values, const Eigen::VectorXd& limits) {
  return (values.cwiseAbs().array() / limits.array()).maxCoeff();
}

TEST(Trajectory, KeepsTheLimitsAtOneKilohertz) {
  constexpr double period = 1e-3;
  for (int seed = 0; seed < paths; ++seed) {
    const RandomPath path = random_path(static_cast<std::uint64_t>(seed));
    const std::vector<JointState> states = sampled(trajectory_of(path), period);
    double velocity = 0.0;
    double acceleration = 0.0;
    double differences = 0.0;
    for (std::size_t i = 0; i < states.size(); ++i) {
      velocity = std::max(velocity, greatest_share(states[i].velocity, path.limits.velocity));
      acceleration =
          std::max(acceleration, greatest_share(states[i].acceleration, path.limits.acceleration));
      if (i < 2 || i + 1 == states.size()) continue;
      const Eigen::VectorXd second =
          (states[i].position - 2.0 * states[i - 1].position + states[i - 2].position) /
          (period * period);
      differences = std::max(differences, greatest_share(second, path.limits.acceleration));
    }
    EXPECT_LE(velocity, 1.0 + 1e-6) << seed;
    EXPECT_LE(acceleration, 1.0 + 1e-6) << seed;
    // A second difference is a mean of the acceleration; rounding of positions adds 1e-9 rad/s².
    EXPECT_LE(differences, 1.0 + 1e-6) << seed;
  }
}

TEST(Trajectory, RunsFromTheFirstWaypointAtRestToTheLast) {
  for (int seed = 0; seed < paths; ++seed) {
    const RandomPath path = random_path(static_cast<std::uint64_t>(seed));
    const std::vector<JointState> states = sampled(trajectory_of(path), 0.01);
    EXPECT_EQ(states.front().position, path.waypoints.front());
    EXPECT_EQ(states.back().position, path.waypoints.back());
    EXPECT_EQ(states.front().velocity.norm(), 0.0);
    EXPECT_EQ(states.back().velocity.norm(), 0.0);
    EXPECT_EQ(states.front().time, 0.0);
    for (std::size_t i = 1; i < states.size(); ++i)
      EXPECT_GT(states[i].time, states[i - 1].time) << seed;
  }
}

TEST(Trajectory, IsContinuousWithItsVelocityAsDerivative) {
  for (int seed = 0; seed < paths / 3; ++seed) {
    const RandomPath path = random_path(static_cast<std::uint64_t>(seed));
    const TimedPath trajectory = trajectory_of(path);
    const double step = 1e-4;
    for (double t = step; t + step < trajectory.duration(); t += 0.0037) {
      const JointState state = trajectory.at(t);
      const Eigen::VectorXd derivative =
          (trajectory.at(t + step).position - trajectory.at(t - step).position) / (2.0 * step);
      // Their difference is at most the change of the velocity within a step.
      const Eigen::VectorXd excess =
          (derivative - state.velocity).cwiseAbs() - step * path.limits.acceleration;
      EXPECT_LE(excess.maxCoeff(), 1e-9) << seed << " at " << t;
    }
  }
}

TEST(Trajectory, StaysWithinTheDeviation) {
  for (const double deviation : {0.0, 0.01, 0.1, 1.0}) {
    double greatest = 0.0;
    for (int seed = 0; seed < paths / 3; ++seed) {
      const RandomPath path = random_path(static_cast<std::uint64_t>(seed));
      for (const JointState& state : sampled(trajectory_of(path, deviation), 0.02))
        greatest = std::max(greatest, distance_from_path(state.position, path.waypoints));
    }
    EXPECT_LE(greatest, deviation + 1e-8);
    EXPECT_GT(greatest, 0.3 * deviation);  // and makes use of it
  }
}

TEST(Trajectory, TakesTheSameTimeBackwards) {
  for (int seed = 0; seed < paths / 3; ++seed) {
    RandomPath path = random_path(static_cast<std::uint64_t>(seed));
    TrajectoryOptions fine;
    fine.arc_step = 0.005;
    const auto duration = [&] {
      return time_optimal_trajectory(path.waypoints, path.limits, fine).duration();
    };
    const double forwards = duration();
    std::reverse(path.waypoints.begin(), path.waypoints.end());
    // Acceleration is constant in each step, which makes the directions differ a little.
    EXPECT_NEAR(duration(), forwards, 1e-3 * forwards) << seed;
  }
}

TEST(Trajectory, ScalesWithTheLimits) {
  for (int seed = 0; seed < paths; ++seed) {
    RandomPath path = random_path(static_cast<std::uint64_t>(seed));
    const double duration = trajectory_of(path).duration();
    const double k = 0.1 + 0.05 * seed;
    path.limits.velocity *= k;
    path.limits.acceleration *= k * k;
    EXPECT_NEAR(trajectory_of(path).duration() * k, duration, 1e-9 * duration) << seed;
  }
}

TEST(Trajectory, IsWithinTwoPercentOfABoundByBruteForce) {
  for (int seed = 0; seed < paths / 5; ++seed) {
    const RandomPath path = random_path(static_cast<std::uint64_t>(seed), 5);
    const TimedPath trajectory = trajectory_of(path);
    if (trajectory.path().segments().empty()) continue;
    const double bound = testing::FastestBound(trajectory.path(), path.limits, 600).duration();
    EXPECT_LE(trajectory.duration(), 1.02 * bound) << seed;
    EXPECT_GE(trajectory.duration(), 0.99 * bound) << seed;
  }
}

TEST(Trajectory, OfOneLineAcceleratesKeepsTheSpeedAndBrakes) {
  const MotionLimits limits{vector({1.0, 5.0}), vector({2.0, 50.0})};
  const TimedPath trajectory =
      time_optimal_trajectory({vector({0.0, 0.0}), vector({3.0, 1.0})}, limits);
  EXPECT_NEAR(trajectory.duration(), 3.0 / 1.0 + 1.0 / 2.0, 1e-12);
  EXPECT_NEAR(trajectory.at(0.5).velocity[0], 1.0, 1e-12);
  EXPECT_NEAR(trajectory.at(1.75).position[0], 1.5, 1e-12);
}

TEST(Trajectory, StopsWhereThePathTurnsBack) {
  const MotionLimits limits{vector({1.0}), vector({1.0})};
  const TimedPath trajectory =
      time_optimal_trajectory({vector({0.0}), vector({1.0}), vector({0.0})}, limits);
  EXPECT_NEAR(trajectory.duration(), 4.0, 1e-12);
  EXPECT_NEAR(trajectory.at(2.0).position[0], 1.0, 1e-12);
  EXPECT_NEAR(trajectory.at(2.0).velocity[0], 0.0, 1e-12);
}

TEST(Trajectory, OfAPathWithoutLengthTakesNoTime) {
  const MotionLimits limits{vector({1.0}), vector({1.0})};
  for (const std::size_t count : {1U, 2U, 5U}) {
    const TimedPath trajectory =
        time_optimal_trajectory(std::vector<Eigen::VectorXd>(count, vector({0.3})), limits);
    EXPECT_EQ(trajectory.duration(), 0.0);
    ASSERT_EQ(sampled(trajectory, 0.01).size(), 1U);
    EXPECT_EQ(sampled(trajectory, 0.01)[0].position, vector({0.3}));
  }
}

TEST(Trajectory, NamesWhatIsInvalid) {
  const MotionLimits limits{vector({1.0}), vector({1.0})};
  const std::vector<Eigen::VectorXd> path{vector({0.0}), vector({1.0})};
  EXPECT_THROW(time_optimal_trajectory({}, limits), InputError);
  EXPECT_THROW(time_optimal_trajectory({vector({0.0}), vector({0.0, 1.0})}, limits), InputError);
  EXPECT_THROW(time_optimal_trajectory({vector({std::nan("")})}, limits), InputError);
  EXPECT_THROW(time_optimal_trajectory(path, {vector({0.0}), vector({1.0})}), InputError);
  EXPECT_THROW(time_optimal_trajectory(path, {vector({1.0}), Eigen::VectorXd()}), InputError);
  EXPECT_THROW(sampled(time_optimal_trajectory(path, limits), 0.0), InputError);
}

}  // namespace
}  // namespace symscene
