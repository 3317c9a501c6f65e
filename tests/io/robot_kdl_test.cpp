// Forward kinematics against KDL's, whose tree is built from urdfdom's model directly.
#ifdef SYMSCENE_WITH_KDL

#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <kdl/tree.hpp>
#include <kdl/treefksolverpos_recursive.hpp>

#include "core/random.hpp"
#include "io_support.hpp"
#include "symscene/io/robot.hpp"

namespace symscene {
namespace {

KDL::Frame frame_of(const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  return KDL::Frame(KDL::Rotation::Quaternion(r.x, r.y, r.z, r.w),
                    KDL::Vector(pose.position.x, pose.position.y, pose.position.z));
}

KDL::Joint joint_of(const urdf::Joint& joint) {
  const KDL::Frame frame = frame_of(joint.parent_to_joint_origin_transform);
  const KDL::Vector axis = frame.M * KDL::Vector(joint.axis.x, joint.axis.y, joint.axis.z);
  if (joint.type == urdf::Joint::FIXED) return KDL::Joint(joint.name, KDL::Joint::None);
  const bool slides = joint.type == urdf::Joint::PRISMATIC;
  return KDL::Joint(joint.name, frame.p, axis,
                    slides ? KDL::Joint::TransAxis : KDL::Joint::RotAxis);
}

void add_children(KDL::Tree& tree, const urdf::Link& link) {
  for (const auto& joint : link.child_joints) {
    const KDL::Frame tip = frame_of(joint->parent_to_joint_origin_transform);
    tree.addSegment(KDL::Segment(joint->child_link_name, joint_of(*joint), tip), link.name);
  }
  for (const auto& child : link.child_links) add_children(tree, *child);
}

/// By joint, as KDL numbers joints in an order of its own.
KDL::JntArray kdl_positions(const KDL::Tree& tree, const RobotModel& model,
                            const Eigen::VectorXd& q) {
  KDL::JntArray positions(tree.getNrOfJoints());
  for (const auto& [name, element] : tree.getSegments()) {
    const KDL::Joint& joint = element.segment.getJoint();
    if (joint.getType() == KDL::Joint::None) continue;
    const std::size_t position = *model.joints[model.joint_index(joint.getName())].position;
    positions(element.q_nr) = q[static_cast<Eigen::Index>(position)];
  }
  return positions;
}

double greatest_difference(const Eigen::Isometry3d& pose, const KDL::Frame& frame) {
  double most = 0.0;
  for (int row = 0; row < 3; ++row) {
    most = std::max(most, std::abs(pose.translation()[row] - frame.p(row)));
    for (int column = 0; column < 3; ++column)
      most = std::max(most, std::abs(pose.linear()(row, column) - frame.M(row, column)));
  }
  return most;
}

void expect_the_poses_of_kdl(const std::string& text) {
  std::vector<std::string> warnings;
  const RobotModel model = parse_urdf(text, "robot", {}, warnings);
  const auto urdf = urdf::parseURDF(text);
  KDL::Tree tree(urdf->getRoot()->name);
  add_children(tree, *urdf->getRoot());
  KDL::TreeFkSolverPos_recursive solver(tree);
  Random random(1);
  for (int trial = 0; trial < 10; ++trial) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(model.moving_joints()));
    for (double& position : q) position = random.uniform(-3.0, 3.0);
    const auto poses = link_poses(model, q);
    for (std::size_t i = 1; i < model.links.size(); ++i) {
      KDL::Frame frame;
      ASSERT_GE(solver.JntToCart(kdl_positions(tree, model, q), frame, model.links[i].name), 0);
      EXPECT_LT(greatest_difference(poses[i], frame), 1e-9) << model.links[i].name;
    }
  }
}

std::string included_urdf(const std::string& name) {
  return io_test::read_text(std::filesystem::path(SYMSCENE_SOURCE_DIR) / "models/robots" /
                            (name + ".urdf"));
}

TEST(RobotKinematics, OfIncludedRobotsIsThatOfKdl) {
  for (const std::string& name : robot_names()) expect_the_poses_of_kdl(included_urdf(name));
}

TEST(RobotKinematics, OfThePublishedBaxterIsThatOfKdl) {
  const auto data = io_test::data_folder();
  if (!data || !std::filesystem::exists(*data / "robots/baxter.urdf"))
    GTEST_SKIP() << "skipped: no $SYMSCENE_DATA/robots/baxter.urdf";
  expect_the_poses_of_kdl(io_test::read_text(*data / "robots/baxter.urdf"));
}

TEST(RobotKinematics, OfOurBaxterIsThatOfThePublishedOne) {
  const auto data = io_test::data_folder();
  if (!data || !std::filesystem::exists(*data / "robots/baxter.urdf"))
    GTEST_SKIP() << "skipped: no $SYMSCENE_DATA/robots/baxter.urdf";
  std::vector<std::string> warnings;
  const RobotModel published = parse_urdf(io_test::read_text(*data / "robots/baxter.urdf"),
                                          "published", {{"head_pan", 0.0}}, warnings);
  const RobotModel ours = parse_urdf(included_urdf("baxter"), "ours", {}, warnings);
  ASSERT_EQ(ours.moving_joints(), published.moving_joints());
  Random random(2);
  Eigen::VectorXd q(14), q_published(14);
  for (const Joint& joint : ours.joints) {
    if (!joint.position) continue;
    const Joint& other = published.joints[published.joint_index(joint.name)];
    EXPECT_EQ(joint.limits.lower, other.limits.lower) << joint.name;
    EXPECT_EQ(joint.limits.upper, other.limits.upper) << joint.name;
    EXPECT_EQ(joint.limits.velocity, other.limits.velocity) << joint.name;
    const double position = random.uniform(-2.0, 2.0);
    q[static_cast<Eigen::Index>(*joint.position)] = position;
    q_published[static_cast<Eigen::Index>(*other.position)] = position;
  }
  for (const char* link : {"left_hand", "right_hand", "left_lower_elbow", "head"}) {
    const auto a = link_poses(ours, q)[ours.link_index(link)];
    const auto b = link_poses(published, q_published)[published.link_index(link)];
    EXPECT_LT((a.matrix() - b.matrix()).cwiseAbs().maxCoeff(), 1e-9) << link;
  }
}

}  // namespace
}  // namespace symscene

#endif
