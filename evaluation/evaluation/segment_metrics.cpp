#include "symscene/evaluation/segment_metrics.hpp"

#include <algorithm>

#include "assignment.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

double ratio(double part, double whole) { return whole > 0.0 ? part / whole : 1.0; }

double f_measure(double precision, double recall) {
  return precision + recall > 0.0 ? 2.0 * precision * recall / (precision + recall) : 0.0;
}

/// Disjoint masks as one label per point, with their sizes and boundaries.
struct Labeling {
  std::vector<Index> labels;
  std::vector<double> sizes;
  std::vector<std::uint8_t> is_boundary;
  double total = 0.0;
  double boundary_total = 0.0;
};

Labeling labeling_of(const std::vector<PointIndices>& masks, const NeighborLists& neighbors) {
  Labeling result{label_points(masks, neighbors.size()), std::vector<double>(masks.size(), 0.0),
                  std::vector<std::uint8_t>(neighbors.size(), 0), 0.0, 0.0};
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    const Index label = result.labels[i];
    if (label == unlabeled) continue;
    result.sizes[label] += 1.0;
    result.total += 1.0;
    const auto others = neighbors.of(i);
    const bool is_boundary = std::any_of(others.begin(), others.end(),
                                         [&](Index j) { return result.labels[j] != label; });
    result.is_boundary[i] = is_boundary ? 1 : 0;
    result.boundary_total += is_boundary ? 1.0 : 0.0;
  }
  return result;
}

/// Overlap F of every true mask with every found one.
OverlapMatrix overlap_f(const Labeling& truth, const Labeling& found, OverlapMatrix& common) {
  common.setZero(static_cast<Eigen::Index>(truth.sizes.size()),
                 static_cast<Eigen::Index>(found.sizes.size()));
  for (std::size_t i = 0; i < truth.labels.size(); ++i) {
    if (truth.labels[i] != unlabeled && found.labels[i] != unlabeled)
      common(truth.labels[i], found.labels[i]) += 1.0;
  }
  OverlapMatrix f = common;
  for (std::size_t t = 0; t < truth.sizes.size(); ++t) {
    for (std::size_t k = 0; k < found.sizes.size(); ++k) {
      const double sizes = truth.sizes[t] + found.sizes[k];
      double& entry = f(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k));
      entry = sizes > 0.0 ? 2.0 * entry / sizes : 0.0;
    }
  }
  return f;
}

/// The number of boundary points of one labelling that match the boundary of the mask that
/// `partner` assigns to their own.
double met_boundary(const Labeling& of, const Labeling& other, const std::vector<Index>& partner,
                    const NeighborLists& neighbors) {
  double met = 0.0;
  for (std::size_t i = 0; i < of.labels.size(); ++i) {
    if (of.is_boundary[i] == 0 || partner[of.labels[i]] == unlabeled) continue;
    const Index wanted = partner[of.labels[i]];
    const auto meets = [&](std::size_t j) {
      return other.is_boundary[j] != 0 && other.labels[j] == wanted;
    };
    const auto near = neighbors.of(i);
    if (meets(i) || std::any_of(near.begin(), near.end(), meets)) met += 1.0;
  }
  return met;
}

}  // namespace

SegmentMetrics& SegmentMetrics::operator+=(const SegmentMetrics& other) {
  overlap_precision += other.overlap_precision;
  overlap_recall += other.overlap_recall;
  overlap_f += other.overlap_f;
  if (other.with_boundary > 0.0) {
    boundary_precision += other.boundary_precision;
    boundary_recall += other.boundary_recall;
    boundary_f += other.boundary_f;
    with_boundary += other.with_boundary;
  }
  found_75 += other.found_75;
  return *this;
}

SegmentMetrics SegmentMetrics::mean(std::size_t scenes) const {
  const double n = scenes == 0 ? 1.0 : static_cast<double>(scenes);
  const double b = with_boundary > 0.0 ? with_boundary : 1.0;
  return {overlap_precision / n, overlap_recall / n, overlap_f / n,     boundary_precision / b,
          boundary_recall / b,   boundary_f / b,     with_boundary / n, found_75 / n};
}

std::vector<Index> label_points(const std::vector<PointIndices>& masks, std::size_t point_count) {
  std::vector<Index> labels(point_count, unlabeled);
  for (std::size_t k = masks.size(); k-- > 0;) {
    for (const Index i : masks[k]) {
      if (i >= point_count) {
        throw InputError("mask " + std::to_string(k),
                         "indices below " + std::to_string(point_count), std::to_string(i));
      }
      labels[i] = static_cast<Index>(k);
    }
  }
  return labels;
}

SegmentMetrics segment_metrics(const std::vector<PointIndices>& truth,
                               const std::vector<PointIndices>& found,
                               const NeighborLists& neighbors) {
  const Labeling of_truth = labeling_of(truth, neighbors);
  const Labeling of_found = labeling_of(found, neighbors);
  OverlapMatrix common;
  const OverlapMatrix f = overlap_f(of_truth, of_found, common);
  std::vector<Index> found_for(truth.size(), unlabeled);
  std::vector<Index> truth_for(found.size(), unlabeled);
  double shared = 0.0;
  double well_found = 0.0;
  for (const MaskPair& pair : assign_masks(f)) {
    found_for[pair.truth] = pair.found;
    truth_for[pair.found] = pair.truth;
    shared += common(pair.truth, pair.found);
    well_found += pair.overlap >= 0.75 ? 1.0 : 0.0;
  }
  SegmentMetrics metrics;
  metrics.overlap_precision = ratio(shared, of_found.total);
  metrics.overlap_recall = ratio(shared, of_truth.total);
  metrics.overlap_f = f_measure(metrics.overlap_precision, metrics.overlap_recall);
  metrics.boundary_precision =
      ratio(met_boundary(of_found, of_truth, truth_for, neighbors), of_found.boundary_total);
  metrics.boundary_recall =
      ratio(met_boundary(of_truth, of_found, found_for, neighbors), of_truth.boundary_total);
  metrics.boundary_f = f_measure(metrics.boundary_precision, metrics.boundary_recall);
  metrics.with_boundary = of_truth.boundary_total > 0.0 ? 1.0 : 0.0;
  metrics.found_75 = ratio(well_found, static_cast<double>(truth.size()));
  return metrics;
}

}  // namespace symscene
