#include "symscene/io/trajectory.hpp"
#include "io/pose_formats.hpp"

#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

Trajectory random_trajectory(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> number;
  Trajectory trajectory;
  for (int i = 0; i < size; ++i) {
    StampedPose pose;
    pose.time = 1305031102.160407 + 0.033 * i;
    const Eigen::Quaterniond rotation(number(random), number(random), number(random),
                                      number(random));
    pose.T_world_camera.linear() = rotation.normalized().toRotationMatrix();
    pose.T_world_camera.translation() << number(random), number(random), number(random);
    trajectory.push_back(pose);
  }
  return trajectory;
}

void expect_same(const Trajectory& a, const Trajectory& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].time, b[i].time);
    EXPECT_TRUE(a[i].T_world_camera.isApprox(b[i].T_world_camera, 1e-14));
  }
}

TEST(Trajectory, WritingAndReadingGiveTheSame) {
  const TemporaryFolder folder;
  const Trajectory trajectory = random_trajectory(50, 1);
  write_text(folder / "poses.txt", format_trajectory(trajectory));
  expect_same(read_trajectory(folder / "poses.txt"), trajectory);
  EXPECT_TRUE(parse_trajectory("", "x").empty());
}

TEST(Trajectory, CommentsAreSkippedAndQuaternionsNormalised) {
  const Trajectory a = parse_trajectory("# time tx ...\n\n1 2 3 4 0 0 1 1 # here\r\n", "x");
  expect_same(a, parse_trajectory("1 2 3 4 0 0 1e-200 1e-200", "x"));
  EXPECT_TRUE((a[0].T_world_camera * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d(2, 4, 4)));
}

TEST(Trajectory, InvalidLinesAreRefusedWithTheirNumber) {
  const auto message = [](const char* text) {
    return refusal([&] { parse_trajectory(text, "poses.txt"); });
  };
  EXPECT_EQ(message("# x\n1 2 3\n"),
            "poses.txt: line 2: expected eight numbers: time tx ty tz qx qy qz qw, found 3 words");
  EXPECT_EQ(message("2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n"),
            "poses.txt: line 2: expected a time not before 2, found 1");
  EXPECT_EQ(message("1 0 0 0 0 0 0 0"),
            "poses.txt: line 1: expected a quaternion of some length, found zeros");
  EXPECT_NE(message("1 0 0 nan 0 0 0 1").find("\"nan\""), std::string::npos);
  EXPECT_NE(message("1 0 0 inf 0 0 0 1").find("\"inf\""), std::string::npos);
}

TEST(Trajectory, DamagedFilesAreReadOrRefused) {
  damage(format_trajectory(random_trajectory(5, 2)),
         [](std::string_view bytes) { parse_trajectory(bytes, "x"); });
}

TEST(Trajectory, PosesAreInterpolatedLinearlyAndSpherically) {
  Trajectory trajectory(2);
  trajectory[0].time = 10.0;
  trajectory[1].time = 10.08;
  trajectory[1].T_world_camera.translation() << 0.8, 0.0, 0.0;
  trajectory[1].T_world_camera.linear() =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto pose = pose_at(trajectory, 10.02, 0.1);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->translation().x(), 0.2, 1e-9);
  EXPECT_NEAR(Eigen::AngleAxisd(pose->linear()).angle(), 0.1, 1e-9);
  EXPECT_TRUE(pose_at(trajectory, 10.0, 0.1) && pose_at(trajectory, 10.08, 0.1));
  EXPECT_FALSE(pose_at(trajectory, 9.99, 0.1) || pose_at(trajectory, 10.09, 0.1));
  EXPECT_FALSE(pose_at(trajectory, 10.02, 0.05));
  EXPECT_FALSE(pose_at({}, 10.02, 0.05));
}

TEST(PoseMatrix, IsReadByRows) {
  const auto pose = parse_pose_matrix("0 -1 0 1\n1 0 0 2\n0 0 1 3\n0 0 0 1\n", "x");
  ASSERT_TRUE(pose);
  EXPECT_TRUE((*pose * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d(1, 3, 3)));
}

TEST(PoseMatrix, IsNothingWhereTrackingWasLost) {
  EXPECT_FALSE(parse_pose_matrix("nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "x"));
  EXPECT_FALSE(parse_pose_matrix("-inf 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "x"));
}

TEST(PoseMatrix, AnythingButARotationAndTranslationIsRefused) {
  for (const char* text :
       {"", "1 0 0 0", "1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1", "2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1",
        "1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1"}) {
    EXPECT_THROW(parse_pose_matrix(text, "x"), InputError) << text;
  }
}

TEST(TrajectoryLog, UsesTheNumbersOfFramesAsTimes) {
  const Trajectory log = parse_trajectory_log(
      "3 3 4\n1 0 0 1\n0 1 0 2\n0 0 1 3\n0 0 0 1\n7 7 8\n0 -1 0 0\n1 0 0 0\n0 0 1 0\n0 0 0 1\n",
      "x");
  ASSERT_EQ(log.size(), 2U);
  EXPECT_EQ(log[0].time, 3.0);
  EXPECT_EQ(log[0].T_world_camera.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(log[1].time, 7.0);
  EXPECT_EQ(refusal([] { parse_trajectory_log("0 0 1\n1 0 0", "a.log"); }),
            "a.log: pose 0: expected the 16 numbers of a 4×4 matrix, found the end of the file");
}

}  // namespace
}  // namespace symscene
