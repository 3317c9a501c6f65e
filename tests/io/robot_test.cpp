#include "symscene/io/robot.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "io/urdf_tree.hpp"
#include "io_support.hpp"
#include "symscene/core/error.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace symscene {
namespace {

#ifndef SYMSCENE_HAS_ROBOTS

TEST(RobotFile, SaysWhichPackagesItNeeds) {
  try {
    read_robot("panda");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.expected().find("-dev"), std::string::npos);
  }
}

#else

/// A URDF file with one revolute joint; `joint` and `links` are inserted.
std::string urdf_with(const std::string& joint, const std::string& more = "") {
  return R"(<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute">
    <parent link="a"/><child link="b"/>)" +
         joint + "</joint>" + more + "</robot>";
}
const std::string limits = R"(<limit lower="-1" upper="1" velocity="2" effort="3"/>)";

RobotModel parsed(const std::string& text, const LockedJoints& locked = {}) {
  std::vector<std::string> warnings;
  return parse_urdf(text, "r.urdf", locked, warnings);
}

/// The message of the error that `call` throws.
template <class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void expect_error(const std::string& text, const std::string& part,
                  const LockedJoints& locked = {}) {
  const std::string message = message_of([&] { parsed(text, locked); });
  EXPECT_NE(message.find("r.urdf"), std::string::npos) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(Urdf, ReadsAJoint) {
  const RobotModel model = parsed(urdf_with(limits + R"(<origin xyz="1 2 3" rpy="0 0 1.5"/>)"
                                                     R"(<axis xyz="0 2 0"/>)"));
  ASSERT_EQ(model.joints.size(), 1U);
  const Joint& joint = model.joints[0];
  EXPECT_EQ(joint.kind, JointKind::revolute);
  EXPECT_EQ(joint.axis, Eigen::Vector3d::UnitY());
  EXPECT_EQ(joint.T_parent_joint.translation(), Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_NEAR(joint.T_parent_joint.linear()(1, 0), std::sin(1.5), 1e-15);
  EXPECT_EQ(joint.limits.lower, -1.0);
  EXPECT_EQ(joint.limits.velocity, 2.0);
  EXPECT_TRUE(std::isinf(joint.limits.acceleration));
}

TEST(Urdf, RefusesRobotsThatItCannotMove) {
  expect_error("no xml", "a robot in URDF");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<robot>";
  expect_error(deep, "inside one another");
  expect_error(urdf_with(""), "limits");
  expect_error(urdf_with(R"(<limit velocity="1" effort="1"/>)"), "lower limit below");
  expect_error(urdf_with(R"(<limit lower="-1" upper="1" velocity="0" effort="1"/>)"), "velocity");
  expect_error(urdf_with(limits + R"(<axis xyz="0 0 0"/>)"), "an axis");
  expect_error(urdf_with(limits + R"(<origin xyz="nan 0 0"/>)"), "r.urdf");
  expect_error(urdf_with(limits + R"(<mimic joint="k"/>)"), "mimics k");
  const std::string back = R"(<joint name="back" type="fixed"><parent link="b"/>
    <child link="a"/></joint>)";
  expect_error(urdf_with(limits, back), "loop");
  const std::string apart = R"(<link name="c"/><link name="d"/><joint name="c1" type="fixed">
    <parent link="c"/><child link="d"/></joint><joint name="c2" type="fixed"><parent link="d"/>
    <child link="c"/></joint>)";
  expect_error(urdf_with(limits, apart), "loop");
  const std::string second = R"(<link name="c"/><joint name="c1" type="fixed"><parent link="a"/>
    <child link="c"/></joint><joint name="c2" type="fixed"><parent link="b"/>
    <child link="c"/></joint>)";
  expect_error(urdf_with(limits, second), "one parent");
  expect_error(urdf_with(limits, R"(<joint name="k" type="fixed"><parent link="b"/>
    <child link="x"/></joint>)"),
               "r.urdf");
  expect_error(urdf_with(limits), "did you mean \"j\"?", {{"jj", 0.0}});
}

TEST(Urdf, RefusesLoopsWithAndWithoutARoot) {
  const auto joint = [](const std::string& parent, const std::string& child) {
    return "<joint><parent link='" + parent + "'/><child link='" + child + "'/></joint>";
  };
  const auto accepted = [](const std::string& joints) {
    try {
      require_trees("<robot>" + joints + "</robot>", "r.urdf");
      return true;
    } catch (const InputError&) {
      return false;
    }
  };
  EXPECT_TRUE(accepted(joint("a", "b") + joint("b", "c") + joint("a", "d")));
  EXPECT_FALSE(accepted(joint("a", "a")));
  EXPECT_FALSE(accepted(joint("a", "b") + joint("c", "d") + joint("d", "c")));
  EXPECT_FALSE(accepted(joint("a", "b") + joint("c", "b")));
  EXPECT_TRUE(accepted("<joint/>"));
}

TEST(Urdf, LocksJointsAndThoseThatMimicThem) {
  const std::string follower = R"(<link name="c"/><joint name="k" type="revolute">
    <parent link="a"/><child link="c"/><axis xyz="0 0 1"/><mimic joint="j" multiplier="-2"
    offset="0.1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>)";
  const RobotModel model = parsed(urdf_with(limits, follower), {{"j", 0.5}});
  EXPECT_EQ(model.moving_joints(), 0U);
  const auto poses = link_poses(model, Eigen::VectorXd(0));
  const Eigen::Matrix3d R = poses[*model.find_link("c")].linear();
  EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)), -0.9, 1e-12);
}

TEST(Urdf, WarnsOfLinksWhoseShapeIsAMesh) {
  std::vector<std::string> warnings;
  const std::string text = R"(<robot name="r"><link name="a"><collision><geometry>
    <mesh filename="a.stl"/></geometry></collision></link></robot>)";
  EXPECT_TRUE(parse_urdf(text, "r.urdf", {}, warnings).links[0].capsules.empty());
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("no collision shape: a"), std::string::npos);
}

TEST(RobotFile, HasARobotForEveryName) {
  for (const std::string& name : robot_names()) {
    const Robot robot = read_robot(name);
    EXPECT_EQ(robot.model.name, name);
    EXPECT_TRUE(robot.warnings.empty());
    EXPECT_TRUE(robot.camera && robot.camera->arm);
    EXPECT_TRUE(robot.grasping_arm().gripper);
    for (const RobotArm& arm : robot.arms) EXPECT_EQ(arm.arm.positions.size(), 7U);
  }
}

TEST(RobotFile, OfBaxterSeesWithTheLeftArmAndGraspsWithTheRight) {
  const Robot baxter = read_robot("baxter");
  EXPECT_EQ(baxter.grasping_arm().arm.name, "right");
  EXPECT_EQ(baxter.arms[*baxter.camera->arm].arm.name, "left");
}

TEST(RobotFile, OfThePandaHasItsToolWhereFrankaSays) {
  // O_T_EE of the ready pose, which is our home, by the robot itself.
  const Robot panda = read_robot("panda");
  const auto poses = link_poses(panda.model, panda.home);
  const Eigen::Isometry3d& tool = poses[panda.model.link_index("panda_hand_tcp")];
  EXPECT_LT((tool.translation() - Eigen::Vector3d(0.307, 0.0, 0.487)).norm(), 1e-3);
  EXPECT_TRUE(tool.linear().col(2).isApprox(-Eigen::Vector3d::UnitZ(), 1e-5));
}

TEST(RobotFile, SolvesRandomReachablePosesOfEveryArm) {
  constexpr int poses = 200;
  for (const std::string& name : robot_names()) {
    const Robot robot = read_robot(name);
    for (const RobotArm& arm : robot.arms) {
      const ArmChain chain = arm_chain(robot.model, arm.arm);
      Random random(11);
      int solved = 0;
      for (int i = 0; i < poses; ++i) {
        Eigen::VectorXd q(7);
        for (int k = 0; k < 7; ++k)
          q[k] = random.uniform(chain.joints[static_cast<std::size_t>(k)].lower,
                                chain.joints[static_cast<std::size_t>(k)].upper);
        const Eigen::Isometry3d T = tip_pose(chain, q);
        const auto result = inverse_kinematics(chain, T);
        const Eigen::Isometry3d reached = tip_pose(chain, result.positions);
        if (result.converged() && reached.isApprox(T, 1e-5)) ++solved;
      }
      EXPECT_GE(solved, 199) << name << " " << arm.arm.name;
    }
  }
}

/// Least distance of the capsules of two links, between points along the capsules.
double link_distance(const RobotModel& model, const std::vector<Eigen::Isometry3d>& poses,
                     const std::pair<std::size_t, std::size_t>& pair) {
  constexpr int steps = 10;
  double least = 1e9;
  for (const Capsule& a : model.links[pair.first].capsules) {
    for (const Capsule& b : model.links[pair.second].capsules) {
      for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j <= steps; ++j) {
          const Eigen::Vector3d p = a.begin + (a.end - a.begin) * i / steps;
          const Eigen::Vector3d q = b.begin + (b.end - b.begin) * j / steps;
          const double between = (poses[pair.first] * p - poses[pair.second] * q).norm();
          least = std::min(least, between - a.radius - b.radius);
        }
      }
    }
  }
  return least;
}

TEST(RobotFile, HasRobotsThatDoNotCollideWithThemselvesAtHome) {
  for (const std::string& name : robot_names()) {
    const Robot robot = read_robot(name);
    const auto poses = link_poses(robot.model, robot.home);
    const auto pairs = self_collision_pairs(robot.model);
    EXPECT_FALSE(pairs.empty());
    for (const auto& pair : pairs)
      EXPECT_GT(link_distance(robot.model, poses, pair), 0.01)
          << robot.model.links[pair.first].name << " " << robot.model.links[pair.second].name;
  }
}

const std::string description = R"(urdf: r.urdf
arms: [{name: arm, base_link: a, tip_link: b, gripper: panda}]
home: {j: 0.5}
acceleration_limits: {j: 4}
)";

class RobotFileInFolder : public ::testing::Test {
 protected:
  void SetUp() override { io_test::write_text(folder_ / "r.urdf", urdf_with(limits)); }
  Robot robot(const std::string& text) const {
    return parse_robot(text, "r.yaml", (folder_ / "r.urdf").parent_path());
  }
  void expect_error(const std::string& text, const std::string& part) const {
    const std::string message = message_of([&] { robot(text); });
    EXPECT_NE(message.find("r.yaml"), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }

  io_test::TemporaryFolder folder_;
};

TEST_F(RobotFileInFolder, DescribesARobot) {
  const Robot read = robot(description + R"(base_pose: {position_m: [1, 2, 3], rpy_deg: [0, 0, 90]}
camera: {link: b, pose: {position_m: [0, 0, 0.1], orientation_xyzw: [0, 0, 0, 1]}}
ignored_collisions: [[b, a]]
obstacles: [{begin_m: [0, 0, 0], end_m: [0, 0, -1], radius_m: 0.2}]
)");
  EXPECT_EQ(read.arms[0].gripper, "panda");
  EXPECT_EQ(read.home, Eigen::VectorXd::Constant(1, 0.5));
  EXPECT_EQ(read.model.joints[0].limits.acceleration, 4.0);
  EXPECT_TRUE((read.T_world_base * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d(1, 3, 3)));
  EXPECT_EQ(read.camera->arm, std::size_t{0});
  EXPECT_EQ(read.model.ignored_pairs.size(), 1U);
  ASSERT_EQ(read.model.links[0].capsules.size(), 1U);
  EXPECT_EQ(read.model.links[0].capsules[0].radius, 0.2);
}

TEST_F(RobotFileInFolder, StartsFromAnIncludedRobot) {
  const Robot moved = robot("robot: panda\nbase_pose: {position_m: [0, 0, 1], rpy_deg: [0, 0, 0]}");
  EXPECT_EQ(moved.T_world_base.translation(), Eigen::Vector3d::UnitZ());
  EXPECT_EQ(moved.home, read_robot("panda").home);
}

TEST_F(RobotFileInFolder, RefusesWhatDoesNotFit) {
  expect_error(description + "hoem: 1", "did you mean \"home\"?");
  expect_error(description + "home: {j: 0}", "again on line");
  expect_error("a: [", "a mistake on line");
  expect_error("urdf: r.urdf\narms: [{name: x, base_link: a, tip_link: bb}]", "link");
  expect_error("robot: pandda", "did you mean \"panda\"?");
  const auto replaced = [](const std::string& from, const std::string& to) {
    std::string text = description;
    return text.replace(text.find(from), from.size(), to);
  };
  expect_error(replaced("{j: 0.5}", "{j: 1.5}"), "[-1, 1]");
  expect_error(replaced("{j: 0.5}", "{j: .nan}"), "a number");
  expect_error(replaced("{j: 0.5}", "{}"), "a position of joint j");
  expect_error(replaced("acceleration_limits: {j: 4}", ""), "a limit of joint j");
  expect_error(replaced("tip_link: b", "tip_link: a"), "a moving joint");
  const std::string loop = "&loop [*loop]";
  expect_error(description + "obstacles: " + loop, "r.yaml");
}

TEST(RobotFile, NamesTheNearestRobot) {
  EXPECT_NE(message_of([] { read_robot("baxtr"); }).find("did you mean \"baxter\"?"),
            std::string::npos);
}

#endif

}  // namespace
}  // namespace symscene
