#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "segmentation/surface_regions.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/proposals/object_features.hpp"
#include "symscene/proposals/proposals.hpp"
#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

/// The scene of the proposals; the referenced objects must outlive the extractor.
struct SegmentedScene {
  const PointCloud& cloud;
  const std::vector<WeightedEdge>& edges;  ///< surface graph of the cloud
  const DistanceField& field;
  const SurfaceRegions& regions;  ///< smooth regions
  const SurfaceRegions& patches;  ///< patch regions
};

/// Computes the features of proposals of one scene.
class ObjectFeatureExtractor {
 public:
  ObjectFeatureExtractor(const SegmentedScene& scene, const ProposalOptions& options);

  /// `merged` has points.
  OwnFeatures features(const MergedHypothesis& merged) const;

 private:
  using Flags = std::vector<std::uint8_t>;
  struct Neighbor {
    Index index;
    float weight;
    bool concave;
  };
  struct EdgeFeatures {
    double broken, torn, rim, bend, crease;
  };
  struct PairFeatures {
    double convexity, empty;
  };
  struct ExtentFeatures {
    double width_ratio, thickness_ratio;
  };

  bool is_crease(const Neighbor& neighbor) const;
  EdgeFeatures edge_features(const PointIndices& points, const Flags& inside) const;
  PairFeatures pair_features(const PointIndices& points) const;
  ExtentFeatures extent_features(const PointIndices& points) const;
  double largest_component(const PointIndices& points, Flags inside) const;
  double share_near_others(const PointIndices& points, const Flags& inside) const;

  SegmentedScene scene_;
  const ProposalOptions& options_;
  std::vector<Index> first_;  ///< N+1: the neighbours of i are [first_[i], first_[i + 1])
  std::vector<Neighbor> neighbors_;
  CellList cells_;
};

}  // namespace symscene
