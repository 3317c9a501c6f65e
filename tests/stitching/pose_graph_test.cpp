#include "stitching/pose_graph.hpp"

#include <gtest/gtest.h>

#include <random>

namespace symscene {
namespace {

Eigen::Isometry3d random_pose(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      Eigen::Quaterniond(uniform(random), uniform(random), uniform(random), uniform(random))
          .normalized()
          .toRotationMatrix();
  pose.translation() << uniform(random), uniform(random), uniform(random);
  return pose;
}

PoseEdge edge(std::span<const Eigen::Isometry3d> poses, std::size_t first, std::size_t second,
              double weight) {
  return {first, second, poses[first].inverse() * poses[second], weight};
}

std::vector<Eigen::Isometry3d> random_poses(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < count; ++i) poses.push_back(random_pose(random));
  return poses;
}

TEST(PoseGraph, ChainsPosesInAnyOrderOfEdges) {
  const auto truth = random_poses(6, 1);
  std::vector<PoseEdge> edges{edge(truth, 0, 3, 5), edge(truth, 3, 5, 9), edge(truth, 1, 5, 2),
                              edge(truth, 1, 2, 7), edge(truth, 2, 4, 1)};
  std::mt19937 random(2);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(edges.begin(), edges.end(), random);
    const auto poses = chain_poses(6, edges);
    for (std::size_t i = 0; i < 6; ++i) {
      ASSERT_TRUE(poses[i]);
      EXPECT_TRUE(poses[i]->isApprox(truth[0].inverse() * truth[i], 1e-12));
    }
  }
}

TEST(PoseGraph, UsesTheEdgesOfGreatestWeight) {
  const auto truth = random_poses(3, 3);
  std::vector<PoseEdge> edges{edge(truth, 0, 1, 10), edge(truth, 1, 2, 10), edge(truth, 0, 2, 3)};
  edges.back().T_first_second.translation().x() += 1.0;
  const auto poses = chain_poses(3, edges);
  EXPECT_TRUE(poses[2]->isApprox(truth[0].inverse() * truth[2], 1e-12));
}

TEST(PoseGraph, LeavesOutFramesOutsideTheLargestGroup) {
  const auto truth = random_poses(6, 4);
  const std::vector<PoseEdge> edges{edge(truth, 0, 1, 100), edge(truth, 2, 4, 1),
                                    edge(truth, 4, 5, 1)};
  const auto poses = chain_poses(6, edges);
  EXPECT_FALSE(poses[0] || poses[1] || poses[3]);
  ASSERT_TRUE(poses[2] && poses[4] && poses[5]);
  EXPECT_TRUE(poses[2]->isApprox(Eigen::Isometry3d::Identity()));
}

TEST(PoseGraph, OfNoFramesIsEmpty) { EXPECT_TRUE(chain_poses(0, {}).empty()); }

}  // namespace
}  // namespace symscene
