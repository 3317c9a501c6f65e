#pragma once

#include <optional>
#include <vector>

#include "symscene/classes/classification.hpp"
#include "symscene/segmentation/class_segmentation_options.hpp"
#include "symscene/segmentation/hypothesis.hpp"

namespace symscene {

/// The points that the surface of a class explains.
struct ClassHypothesis {
  PointIndices points;  ///< ascending
  ObjectClass symmetry_class;
};

/// Points of which a surface is fitted, and the axes that they are known to have.
struct ClassSeed {
  const PointIndices& points;
  const std::vector<ObjectAxis>& axes;
};

/// Cuts out the points that the surface of a class explains (section 4.7 with the graph of 4.3): a
/// box, prism, cylinder or sphere is fitted to the points of a seed (classify()), the points that
/// lie on it with its normal are cut out, it is fitted to them again and cut once more. `spacing`
/// is that of the cloud. One entry per seed, none where no surface explains the points; the same
/// for any number of threads. Throws InputError if an option is invalid.
std::vector<std::optional<ClassHypothesis>> segment_classes(
    const ObservedSurface& surface, double spacing, const std::vector<ClassSeed>& seeds,
    const ClassOptions& fit, const ClassSegmentationOptions& options);

}  // namespace symscene
