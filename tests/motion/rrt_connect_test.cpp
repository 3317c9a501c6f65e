#include "symscene/motion/rrt_connect.hpp"

#include <numbers>
#include <queue>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "motion/path_shortcuts.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using Path = std::vector<Eigen::VectorXd>;

JointSpace square() { return {Eigen::VectorXd::Zero(2), Eigen::VectorXd::Ones(2), {false, false}}; }

Eigen::VectorXd point(double x, double y) { return Eigen::Vector2d(x, y); }

/// Discs in the unit square.
struct Discs {
  std::vector<Eigen::Vector3d> discs;  ///< x, y, radius

  static Discs random(std::uint64_t seed) {
    Random random(seed);
    Discs made;
    for (int i = 0; i < 25; ++i)
      made.discs.emplace_back(random.uniform(), random.uniform(), random.uniform(0.04, 0.13));
    return made;
  }
  bool covers(double x, double y, double margin = 0.0) const {
    return std::any_of(discs.begin(), discs.end(), [&](const Eigen::Vector3d& disc) {
      return std::hypot(disc.x() - x, disc.y() - y) < disc.z() + margin;
    });
  }
  MotionValidity validity() const {
    return {[this](const Eigen::VectorXd& q) {
      return covers(q[0], q[1]) ? std::string("disc") : std::string();
    }};
  }
  /// Whether a flood on a fine grid leads from one corner to the other, with discs larger by
  /// `margin`.
  bool corners_are_connected(double margin) const {
    constexpr int n = 200;
    std::vector<bool> seen(static_cast<std::size_t>(n * n));
    std::queue<std::pair<int, int>> front;
    const auto visit = [&](int i, int j) {
      if (i < 0 || j < 0 || i >= n || j >= n) return;
      const auto cell = static_cast<std::size_t>(i * n + j);
      if (seen[cell] || covers(i / (n - 1.0), j / (n - 1.0), margin)) return;
      seen[cell] = true;
      front.emplace(i, j);
    };
    for (visit(0, 0); !front.empty(); front.pop()) {
      const auto [i, j] = front.front();
      visit(i + 1, j);
      visit(i - 1, j);
      visit(i, j + 1);
      visit(i, j - 1);
    }
    return seen.back();
  }
};

/// A wall at x = 0.5 with a gap below `gap`.
MotionValidity wall(double gap) {
  return {[gap](const Eigen::VectorXd& q) {
    return std::abs(q[0] - 0.5) < 0.05 && q[1] >= gap ? std::string("wall") : std::string();
  }};
}

double length_of(const Path& path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += (path[i] - path[i - 1]).norm();
  return sum;
}

TEST(RrtConnect, TakesTheStraightLineWhereItIsFree) {
  const PathResult result = rrt_connect(square(), point(0.1, 0.1), {point(0.4, 0.9)}, wall(0.2));
  EXPECT_EQ(result.status, PathStatus::found);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.waypoints.size(), 2U);
}

TEST(RrtConnect, FindsAPathWhereAFloodDoesAndOnlyThere) {
  int connected = 0;
  int separate = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Discs discs = Discs::random(seed);
    if (discs.covers(0.0, 0.0) || discs.covers(1.0, 1.0)) continue;
    const bool must_find = discs.corners_are_connected(0.005);
    const bool cannot_find = !discs.corners_are_connected(-0.01);
    RrtConnectOptions options;
    options.max_step = 0.1;
    options.resolution = 0.002;
    options.max_iterations = must_find ? 20000 : 1000;
    const bool found =
        rrt_connect(square(), point(0.0, 0.0), {point(1.0, 1.0)}, discs.validity(), options)
            .status == PathStatus::found;
    EXPECT_TRUE(found || !must_find) << seed;
    EXPECT_FALSE(found && cannot_find) << seed;
    connected += must_find ? 1 : 0;
    separate += cannot_find ? 1 : 0;
  }
  EXPECT_GE(connected, 3);
  EXPECT_GE(separate, 2);
}

TEST(RrtConnect, GivesAFreePathFromTheStartToTheGoal) {
  RrtConnectOptions options;
  options.resolution = 0.002;
  const MotionValidity validity = wall(0.1);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    options.seed = seed;
    const PathResult result =
        rrt_connect(square(), point(0.1, 0.9), {point(0.9, 0.9)}, validity, options);
    ASSERT_EQ(result.status, PathStatus::found);
    const Path& path = result.waypoints;
    EXPECT_EQ(path.front(), point(0.1, 0.9));
    EXPECT_NEAR((path.back() - point(0.9, 0.9)).norm(), 0.0, 1e-12);
    EXPECT_LT(length_of(path), 2.5);  // around the wall it is about 1.9
    for (std::size_t i = 1; i < path.size(); ++i) {
      for (double share = 0.0; share <= 1.0; share += 0.001) {
        const Eigen::VectorXd q = path[i - 1] + share * (path[i] - path[i - 1]);
        EXPECT_TRUE(validity.obstacle(q - point(0.0, 0.002)).empty()) << seed;
      }
    }
  }
}

TEST(RrtConnect, RepeatsItselfWithOneSeedAndNotWithAnother) {
  RrtConnectOptions options;
  const auto path = [&] {
    return rrt_connect(square(), point(0.1, 0.9), {point(0.9, 0.9)}, wall(0.3), options).waypoints;
  };
  const Path first = path();
  EXPECT_EQ(path(), first);
  options.seed = 1;
  EXPECT_NE(path(), first);
}

TEST(RrtConnect, SaysWhatIsWrongWithTheEnds) {
  const PathResult start = rrt_connect(square(), point(0.5, 0.9), {point(0.9, 0.9)}, wall(0.3));
  EXPECT_EQ(start.status, PathStatus::invalid_start);
  EXPECT_EQ(start.obstacle, "wall");
  const PathResult goal = rrt_connect(square(), point(0.1, 0.9), {point(0.5, 0.9)}, wall(0.3));
  EXPECT_EQ(goal.status, PathStatus::invalid_goal);
  EXPECT_EQ(goal.obstacle, "wall");
  const PathResult outside = rrt_connect(square(), point(0.1, 1.9), {point(0.5, 0.9)}, wall(0.3));
  EXPECT_EQ(outside.status, PathStatus::invalid_start);
  EXPECT_NE(outside.obstacle.find("joint 1"), std::string::npos);
}

TEST(RrtConnect, GivesUpAfterItsBudget) {
  RrtConnectOptions options;
  options.max_iterations = 300;
  const PathResult result =
      rrt_connect(square(), point(0.1, 0.9), {point(0.9, 0.9)}, wall(0.0), options);
  EXPECT_EQ(result.status, PathStatus::no_path);
  EXPECT_EQ(result.iterations, 300);
  EXPECT_TRUE(result.waypoints.empty());
}

TEST(RrtConnect, ReachesTheGoalThatCanBeReached) {
  RrtConnectOptions options;
  options.max_iterations = 2000;
  const PathResult result =
      rrt_connect(square(), point(0.1, 0.9), {point(0.9, 0.9), point(0.5, 0.5), point(0.3, 0.2)},
                  wall(0.0), options);
  EXPECT_EQ(result.status, PathStatus::found);
  EXPECT_EQ(result.goal, 2U);
}

TEST(RrtConnect, TurnsContinuousJointsTheShortWay) {
  const JointSpace space{Eigen::VectorXd::Constant(1, -std::numbers::pi),
                         Eigen::VectorXd::Constant(1, std::numbers::pi),
                         {true}};
  const MotionValidity all_free{[](const Eigen::VectorXd&) { return std::string(); }};
  const Path path = rrt_connect(space, Eigen::VectorXd::Constant(1, 3.0),
                                {Eigen::VectorXd::Constant(1, -3.0)}, all_free)
                        .waypoints;
  ASSERT_EQ(path.size(), 2U);
  EXPECT_NEAR(path[1][0], 2.0 * std::numbers::pi - 3.0, 1e-12);
  // Where the short way is blocked, the long one has no jump either.
  const MotionValidity blocked{[](const Eigen::VectorXd& q) {
    return std::cos(q[0]) < -0.999 ? std::string("post") : std::string();
  }};
  const Path around = rrt_connect(space, Eigen::VectorXd::Constant(1, 3.0),
                                  {Eigen::VectorXd::Constant(1, -3.0)}, blocked)
                          .waypoints;
  ASSERT_GE(around.size(), 2U);
  EXPECT_NEAR(around.back()[0], -3.0, 1e-9);
}

TEST(RrtConnect, RefusesInputThatMakesNoSense) {
  const MotionValidity free = wall(2.0);
  EXPECT_THROW(rrt_connect(square(), point(0.1, 0.1), {}, free), InputError);
  EXPECT_THROW(rrt_connect(square(), Eigen::VectorXd::Zero(3), {point(0.1, 0.1)}, free),
               InputError);
  EXPECT_THROW(rrt_connect(square(), point(std::nan(""), 0.1), {point(0.1, 0.1)}, free),
               InputError);
  JointSpace wrong = square();
  wrong.upper[0] = -1.0;
  EXPECT_THROW(rrt_connect(wrong, point(0.0, 0.0), {point(0.1, 0.1)}, free), InputError);
}

TEST(PathShortcuts, NeverLengthenAPathAndKeepItsEnds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Discs discs = Discs::random(seed);
    Path path;
    for (int i = 0; i < 12; ++i) path.push_back(square().sample(random));
    const Path shorter = shortened(
        path,
        [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
          return !discs.covers(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
        },
        50, random);
    EXPECT_EQ(shorter.front(), path.front());
    EXPECT_EQ(shorter.back(), path.back());
    EXPECT_LT(length_of(shorter), length_of(path));
  }
}

}  // namespace
}  // namespace symscene
