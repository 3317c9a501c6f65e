// Supervoxels against those of PCL, whose authors are those of the paper.
#ifdef SYMSCENE_HAS_PCL
#include <pcl/point_types.h>
#include <pcl/segmentation/supervoxel_clustering.h>
#endif

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "segmentation/workspace.hpp"
#include "surfaces.hpp"
#include "symscene/segmentation/supervoxels.hpp"

namespace symscene {
namespace {

#ifdef SYMSCENE_HAS_PCL

using PclPoint = pcl::PointXYZRGBA;

/// PCL's label of every point; 0 where it has none.
std::vector<Index> pcl_labels(const PointCloud& cloud, const SupervoxelOptions& options) {
  auto points = pcl::make_shared<pcl::PointCloud<PclPoint>>();
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  points->resize(cloud.size());
  normals->resize(cloud.size());
  for (Index i = 0; i < cloud.size(); ++i) {
    (*points)[i].getVector3fMap() = cloud.position(i);
    (*normals)[i].getNormalVector3fMap() = cloud.normal(i);
  }
  pcl::SupervoxelClustering<PclPoint> clustering(0.005F, static_cast<float>(options.seed_spacing));
  clustering.setUseSingleCameraTransform(false);
  clustering.setInputCloud(points);
  clustering.setNormalCloud(normals);
  clustering.setColorImportance(0.0F);
  clustering.setSpatialImportance(static_cast<float>(options.spatial_weight));
  clustering.setNormalImportance(static_cast<float>(options.normal_weight));
  std::map<std::uint32_t, pcl::Supervoxel<PclPoint>::Ptr> found;
  clustering.extract(found);
  std::vector<Index> labels;
  for (const pcl::PointXYZL& point : *clustering.getLabeledCloud()) labels.push_back(point.label);
  return labels;
}

/// The face of a box to which each normal belongs.
std::vector<int> faces_of(const PointCloud& cloud) {
  std::vector<int> faces;
  for (Index i = 0; i < cloud.size(); ++i) {
    Eigen::Index axis = 0;
    cloud.normal(i).cwiseAbs().maxCoeff(&axis);
    faces.push_back(2 * static_cast<int>(axis) + (cloud.normal(i)[axis] > 0.0F ? 1 : 0));
  }
  return faces;
}

/// The share of points that lie on the face to which most points of their supervoxel belong: what a
/// segmentation into faces can reach that keeps supervoxels whole.
double achievable_accuracy(const std::vector<Index>& labels, const std::vector<int>& faces) {
  std::map<Index, std::map<int, int>> counts;
  for (std::size_t i = 0; i < labels.size(); ++i) ++counts[labels[i]][faces[i]];
  int right = 0;
  for (const auto& [label, of_faces] : counts) {
    int most = 0;
    for (const auto& [face, count] : of_faces) most = std::max(most, count);
    right += most;
  }
  return static_cast<double>(right) / static_cast<double>(labels.size());
}

TEST(SupervoxelsAgainstPcl, KeepToTheEdgesOfABoxAsWell) {
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const PointCloud box = testing::box({0.1, 0.16, 0.22});
    const PointCloud cloud = testing::moved(box, testing::random_motion(generator));
    const std::vector<int> faces = faces_of(box);
    const SupervoxelOptions options;
    const Partition ours = supervoxels(cloud, voxel_neighbors(cloud.positions, 0.005), options);
    const std::vector<Index> theirs = pcl_labels(cloud, options);
    const double accuracy = achievable_accuracy(ours.labels, faces);
    EXPECT_GT(accuracy, achievable_accuracy(theirs, faces) - 0.01) << "seed " << seed;
    EXPECT_GT(accuracy, 0.97) << "seed " << seed;
    const std::size_t count = std::set<Index>(theirs.begin(), theirs.end()).size();
    EXPECT_LT(ours.count, 2 * count);
    EXPECT_GT(2 * ours.count, count);
  }
}

#else

TEST(SupervoxelsAgainstPcl, KeepToTheEdgesOfABoxAsWell) {
  GTEST_SKIP() << "skipped: PCL is not installed";
}

#endif

}  // namespace
}  // namespace symscene
