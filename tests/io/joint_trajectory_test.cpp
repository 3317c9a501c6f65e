// trajectory.json and .csv: the fields of trajectory_msgs/JointTrajectory, and what is refused.
#include "symscene/io/joint_trajectory.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

Eigen::VectorXd two(double a, double b) { return Eigen::Vector2d(a, b); }

JointTrajectory small_trajectory() {
  JointTrajectory trajectory{{"shoulder", "elbow"},
                             {{0.0, two(0.0, 1.0), two(0.0, 0.0), two(1.0, 0.0)},
                              {0.25, two(0.1, 1.0), two(0.5, 0.0), two(0.0, 0.0)},
                              {1.5, two(0.2, 1e-5), two(0.0, 0.0), two(-1.0, 0.0)}}};
  trajectory.parts = {{"approach", 0, 1}, {"retreat", 1, 2}};
  trajectory.gripper = {{0.0, 0.08}, {0.25, 0.04}};
  return trajectory;
}

TrajectoryPurpose small_purpose() {
  return {"panda", "arm", 1, {}, {{0, 2, "collision", "link5 meets the table"}}};
}

std::string refusal_of(const JointTrajectory& trajectory) {
  try {
    format_joint_trajectory_csv(trajectory);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TrajectoryFile, HasTheFieldsOfJointTrajectory) {
  const auto json =
      nlohmann::json::parse(format_joint_trajectory_json(small_trajectory(), small_purpose()));
  const auto& message = json.at("joint_trajectory");
  EXPECT_EQ(message.at("joint_names"), nlohmann::json({"shoulder", "elbow"}));
  ASSERT_EQ(message.at("points").size(), 3U);
  const auto& point = message.at("points").at(2);
  EXPECT_EQ(point.at("time_from_start"), nlohmann::json({{"sec", 1}, {"nanosec", 500'000'000}}));
  EXPECT_EQ(point.at("positions"), nlohmann::json({0.2, 1e-5}));
  EXPECT_EQ(point.at("velocities"), nlohmann::json({0.0, 0.0}));
  EXPECT_EQ(point.at("accelerations"), nlohmann::json({-1.0, 0.0}));
  EXPECT_EQ(json.at("parts").at(1).at("end"), 2);
  EXPECT_EQ(json.at("gripper").at(1).at("opening_m"), 0.04);
  EXPECT_EQ(json.at("not_reached").at(0).at("reason"), "collision");
  // set_message_fields() refuses members that the message does not have.
  EXPECT_EQ(message.size(), 3U);
  EXPECT_EQ(point.size(), 5U);
}

TEST(TrajectoryFile, NamesTimesAsRos1Does) {
  const auto json = nlohmann::json::parse(
      format_joint_trajectory_json(small_trajectory(), small_purpose(), RosVersion::ros1));
  const auto& point = json.at("joint_trajectory").at("points").at(1);
  EXPECT_EQ(point.at("time_from_start"), nlohmann::json({{"secs", 0}, {"nsecs", 250'000'000}}));
}

TEST(TrajectoryFile, HasALinePerPointAsCsv) {
  EXPECT_EQ(format_joint_trajectory_csv(small_trajectory()),
            "time_s,part,shoulder_position,shoulder_velocity,shoulder_acceleration,"
            "elbow_position,elbow_velocity,elbow_acceleration\n"
            "0,approach,0,0,1,1,0,0\n"
            "0.25,approach,0.1,0.5,0,1,0,0\n"
            "1.5,retreat,0.2,0,-1,1e-05,0,0\n");
}

TEST(TrajectoryFile, RefusesWhatAControllerWouldRefuse) {
  const auto refused = [](const auto& change) {
    JointTrajectory trajectory = small_trajectory();
    change(trajectory);
    return refusal_of(trajectory);
  };
  EXPECT_EQ(refused([](JointTrajectory&) {}), "");
  const std::vector<std::pair<std::string, std::string>> cases{
      {refused([](auto& t) { t.points.clear(); }), "points"},
      {refused([](auto& t) { t.points[1].time = 1.5; }), "increase strictly"},
      {refused([](auto& t) { t.points[1].time = 1e-12; }), "increase strictly"},
      {refused([](auto& t) { t.points[0].time = 0.1; }), "from 0"},
      {refused([](auto& t) { t.points[1].time = std::nan(""); }), "finite"},
      {refused([](auto& t) { t.points[0].velocities[1] = 0.1; }), "velocities of 0"},
      {refused([](auto& t) { t.points[2].velocities[0] = -0.1; }), "velocities of 0"},
      {refused([](auto& t) { t.points[1].positions[0] = std::nan(""); }), "2 finite numbers"},
      {refused([](auto& t) { t.joint_names.pop_back(); }), "1 finite numbers"}};
  for (const auto& [refusal, sentence] : cases)
    EXPECT_NE(refusal.find(sentence), std::string::npos) << sentence << " in: " << refusal;
}

}  // namespace
}  // namespace symscene
