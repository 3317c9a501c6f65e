#include "lccp_labels.hpp"
#include "segmentation/segments_of_labels.hpp"

#ifdef SYMSCENE_HAS_PCL
#include <pcl/point_types.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_PCL

bool has_lccp() { return false; }

std::vector<std::vector<Index>> lccp_labels(const PointCloud&, const LccpOptions&,
                                            std::span<const double>) {
  return {};
}

#else

namespace {

// The point type of the authors' example, which PCL instantiates.
using PclPoint = pcl::PointXYZRGBA;
using Supervoxels = std::map<std::uint32_t, pcl::Supervoxel<PclPoint>::Ptr>;

pcl::PointCloud<PclPoint>::Ptr pcl_positions(const PointCloud& cloud) {
  auto points = pcl::make_shared<pcl::PointCloud<PclPoint>>();
  points->resize(cloud.size());
  for (Index i = 0; i < cloud.size(); ++i) (*points)[i].getVector3fMap() = cloud.position(i);
  return points;
}

pcl::PointCloud<pcl::Normal>::Ptr pcl_normals(const PointCloud& cloud) {
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  normals->resize(cloud.size());
  for (Index i = 0; i < cloud.size(); ++i) (*normals)[i].getNormalVector3fMap() = cloud.normal(i);
  return normals;
}

/// The supervoxels of a cloud and their adjacency.
struct Patches {
  Supervoxels supervoxels;
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  std::vector<std::uint32_t> of_point;  ///< per point, 0 if it is in none
};

Patches find_patches(const PointCloud& cloud, const LccpOptions& options) {
  pcl::SupervoxelClustering<PclPoint> clustering(static_cast<float>(options.voxel_size),
                                                 static_cast<float>(options.seed_spacing));
  // Voxels that grow with depth suit a single view; this cloud is of many.
  clustering.setUseSingleCameraTransform(false);
  clustering.setInputCloud(pcl_positions(cloud));
  clustering.setNormalCloud(pcl_normals(cloud));
  clustering.setColorImportance(0.0F);
  clustering.setSpatialImportance(static_cast<float>(options.spatial_importance));
  clustering.setNormalImportance(static_cast<float>(options.normal_importance));
  Patches patches;
  clustering.extract(patches.supervoxels);
  clustering.getSupervoxelAdjacency(patches.adjacency);
  const pcl::PointCloud<pcl::PointXYZL>::Ptr labeled = clustering.getLabeledCloud();
  for (const pcl::PointXYZL& point : *labeled) patches.of_point.push_back(point.label);
  return patches;
}

std::map<std::uint32_t, std::uint32_t> join_patches(const Patches& patches,
                                                    const LccpOptions& options, double tolerance) {
  pcl::LCCPSegmentation<PclPoint> lccp;
  lccp.setConcavityToleranceThreshold(static_cast<float>(degrees(tolerance)));
  lccp.setSanityCheck(options.sanity_check);
  lccp.setSmoothnessCheck(true, static_cast<float>(options.voxel_size),
                          static_cast<float>(options.seed_spacing),
                          static_cast<float>(options.smoothness));
  lccp.setKFactor(options.extended_convexity ? 1 : 0);
  lccp.setInputSupervoxels(patches.supervoxels, patches.adjacency);
  lccp.segment();
  std::map<std::uint32_t, std::uint32_t> segment_of_patch;
  lccp.getSupervoxelToSegmentMap(segment_of_patch);
  return segment_of_patch;
}

}  // namespace

bool has_lccp() { return true; }

std::vector<std::vector<Index>> lccp_labels(const PointCloud& cloud, const LccpOptions& options,
                                            std::span<const double> tolerances) {
  const Patches patches = find_patches(cloud, options);
  std::vector<std::vector<Index>> labels;
  for (const double tolerance : tolerances) {
    const std::map<std::uint32_t, std::uint32_t> segments =
        join_patches(patches, options, tolerance);
    std::vector<Index>& of_point = labels.emplace_back();
    for (const std::uint32_t patch : patches.of_point) {
      const auto segment = segments.find(patch);
      of_point.push_back(segment == segments.end() ? no_segment : segment->second);
    }
  }
  return labels;
}

#endif

}  // namespace symscene
