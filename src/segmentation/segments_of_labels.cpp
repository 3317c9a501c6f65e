#include "segmentation/segments_of_labels.hpp"

#include <algorithm>
#include <utility>

namespace symscene {

std::vector<PointIndices> segments_of_labels(std::span<const Index> labels, int min_size) {
  std::vector<std::pair<Index, Index>> points;  // by label
  points.reserve(labels.size());
  for (Index i = 0; i < labels.size(); ++i) {
    if (labels[i] != no_segment) points.emplace_back(labels[i], i);
  }
  std::sort(points.begin(), points.end());
  std::vector<PointIndices> segments;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    while (end < points.size() && points[end].first == points[begin].first) ++end;
    if (end - begin < static_cast<std::size_t>(min_size)) continue;
    PointIndices& segment = segments.emplace_back();
    for (std::size_t k = begin; k < end; ++k) segment.push_back(points[k].second);
  }
  std::sort(segments.begin(), segments.end(), [](const PointIndices& a, const PointIndices& b) {
    return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
  });
  return segments;
}

}  // namespace symscene
