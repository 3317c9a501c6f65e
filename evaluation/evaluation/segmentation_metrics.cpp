#include "symscene/evaluation/segmentation_metrics.hpp"

#include <algorithm>
#include <cmath>

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

/// `is_at_border` tells whether a point or pixel has a neighbour of another label.
template <class IsAtBorder>
Labeling labeling_of(std::vector<Index> labels, std::size_t masks, const IsAtBorder& is_at_border) {
  Labeling result{std::move(labels), std::vector<double>(masks, 0.0), {}, 0.0, 0.0};
  result.is_boundary.assign(result.labels.size(), 0);
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    const Index label = result.labels[i];
    if (label == unlabeled) continue;
    result.sizes[label] += 1.0;
    result.total += 1.0;
    const bool is_boundary = is_at_border(result.labels, i);
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
/// `partner` assigns to their own. any_near(i, is_met) tells whether some point near i is met.
template <class AnyNear>
double met_boundary(const Labeling& of, const Labeling& other, const std::vector<Index>& partner,
                    const AnyNear& any_near) {
  double met = 0.0;
  for (std::size_t i = 0; i < of.labels.size(); ++i) {
    if (of.is_boundary[i] == 0 || partner[of.labels[i]] == unlabeled) continue;
    const Index wanted = partner[of.labels[i]];
    const auto is_met = [&](std::size_t j) {
      return other.is_boundary[j] != 0 && other.labels[j] == wanted;
    };
    if (any_near(i, is_met)) met += 1.0;
  }
  return met;
}

/// The metrics but for found_75, which also depends on the pairs.
template <class AnyNear>
SegmentationMetrics metrics_of(const Labeling& of_truth, const Labeling& of_found,
                               const AnyNear& any_near, std::vector<MaskPair>& pairs) {
  OverlapMatrix common;
  pairs = assign_masks(overlap_f(of_truth, of_found, common));
  std::vector<Index> found_for(of_truth.sizes.size(), unlabeled);
  std::vector<Index> truth_for(of_found.sizes.size(), unlabeled);
  double shared = 0.0;
  for (const MaskPair& pair : pairs) {
    found_for[pair.truth] = pair.found;
    truth_for[pair.found] = pair.truth;
    shared += common(pair.truth, pair.found);
  }
  SegmentationMetrics metrics;
  metrics.overlap_precision = ratio(shared, of_found.total);
  metrics.overlap_recall = ratio(shared, of_truth.total);
  metrics.overlap_f = f_measure(metrics.overlap_precision, metrics.overlap_recall);
  metrics.boundary_precision =
      ratio(met_boundary(of_found, of_truth, truth_for, any_near), of_found.boundary_total);
  metrics.boundary_recall =
      ratio(met_boundary(of_truth, of_found, found_for, any_near), of_truth.boundary_total);
  metrics.boundary_f = f_measure(metrics.boundary_precision, metrics.boundary_recall);
  metrics.with_boundary = of_truth.boundary_total > 0.0 ? 1.0 : 0.0;
  return metrics;
}

/// The share of the true objects whose pair satisfies `is_good`.
template <class IsGood>
double share_of(const std::vector<MaskPair>& pairs, std::size_t objects, const IsGood& is_good) {
  const auto good = std::count_if(pairs.begin(), pairs.end(),
                                  [&](const MaskPair& pair) { return is_good(pair.overlap); });
  return ratio(static_cast<double>(good), static_cast<double>(objects));
}

/// The labels of an image as indices from 0, in the order of the labels, and their number.
std::pair<std::vector<Index>, std::size_t> dense_labels(std::span<const std::uint16_t> image) {
  std::vector<Index> index_of(std::size_t{1} << 16U, unlabeled);
  for (const std::uint16_t label : image) index_of[label] = 0;
  index_of[0] = unlabeled;
  std::size_t count = 0;
  for (Index& index : index_of) {
    if (index != unlabeled) index = static_cast<Index>(count++);
  }
  std::vector<Index> labels;
  labels.reserve(image.size());
  for (const std::uint16_t label : image) labels.push_back(index_of[label]);
  return {std::move(labels), count};
}

/// Neighbourhoods of pixels.
class PixelGrid {
 public:
  PixelGrid(std::size_t width, std::size_t height)
      : width_(width),
        height_(height),
        radius_(static_cast<std::ptrdiff_t>(std::ceil(
            0.003 * std::hypot(static_cast<double>(width), static_cast<double>(height))))) {}

  /// Whether one of the four neighbours has another label.
  bool is_at_border(const std::vector<Index>& labels, std::size_t i) const {
    const std::size_t u = i % width_, v = i / width_;
    return (u > 0 && labels[i - 1] != labels[i]) ||
           (u + 1 < width_ && labels[i + 1] != labels[i]) ||
           (v > 0 && labels[i - width_] != labels[i]) ||
           (v + 1 < height_ && labels[i + width_] != labels[i]);
  }

  /// Whether some pixel within the disc satisfies `is_met`.
  template <class IsMet>
  bool any_near(std::size_t i, const IsMet& is_met) const {
    const auto u = static_cast<std::ptrdiff_t>(i % width_);
    const auto v = static_cast<std::ptrdiff_t>(i / width_);
    for (std::ptrdiff_t dv = -radius_; dv <= radius_; ++dv) {
      for (std::ptrdiff_t du = -radius_; du <= radius_; ++du) {
        if (du * du + dv * dv > radius_ * radius_ || u + du < 0 || v + dv < 0) continue;
        const auto column = static_cast<std::size_t>(u + du),
                   row = static_cast<std::size_t>(v + dv);
        if (column < width_ && row < height_ && is_met(row * width_ + column)) return true;
      }
    }
    return false;
  }

 private:
  std::size_t width_;
  std::size_t height_;
  std::ptrdiff_t radius_;  // [px]
};

}  // namespace

SegmentationMetrics& SegmentationMetrics::operator+=(const SegmentationMetrics& other) {
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

SegmentationMetrics SegmentationMetrics::mean(std::size_t scenes) const {
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

SegmentationMetrics segmentation_metrics(const std::vector<PointIndices>& truth,
                                         const std::vector<PointIndices>& found,
                                         const NeighborLists& neighbors) {
  const auto is_at_border = [&](const std::vector<Index>& labels, std::size_t i) {
    const auto others = neighbors.of(i);
    return std::any_of(others.begin(), others.end(),
                       [&](Index j) { return labels[j] != labels[i] && labels[j] != unlabeled; });
  };
  const auto any_near = [&](std::size_t i, const auto& is_met) {
    const auto near = neighbors.of(i);
    return is_met(i) || std::any_of(near.begin(), near.end(), is_met);
  };
  const std::size_t points = neighbors.size();
  std::vector<MaskPair> pairs;
  SegmentationMetrics metrics = metrics_of(
      labeling_of(label_points(truth, points), truth.size(), is_at_border),
      labeling_of(label_points(found, points), found.size(), is_at_border), any_near, pairs);
  metrics.found_75 = share_of(pairs, truth.size(), [](double f) { return f >= 0.75; });
  return metrics;
}

SegmentationMetrics pixel_metrics(std::span<const std::uint16_t> truth,
                                  std::span<const std::uint16_t> found, std::size_t width,
                                  std::size_t height) {
  for (const auto& image : {truth, found}) {
    if (image.size() != width * height)
      throw InputError("label image", std::to_string(width * height) + " pixels",
                       std::to_string(image.size()));
  }
  const PixelGrid grid(width, height);
  const auto is_at_border = [&](const std::vector<Index>& labels, std::size_t i) {
    return grid.is_at_border(labels, i);
  };
  const auto any_near = [&](std::size_t i, const auto& is_met) { return grid.any_near(i, is_met); };
  auto [true_labels, objects] = dense_labels(truth);
  auto [found_labels, masks] = dense_labels(found);
  std::vector<MaskPair> pairs;
  SegmentationMetrics metrics =
      metrics_of(labeling_of(std::move(true_labels), objects, is_at_border),
                 labeling_of(std::move(found_labels), masks, is_at_border), any_near, pairs);
  metrics.found_75 = share_of(pairs, objects, [](double f) { return f > 0.75; });
  return metrics;
}

}  // namespace symscene
