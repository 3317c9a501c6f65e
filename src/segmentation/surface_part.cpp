#include "segmentation/surface_part.hpp"

#include <algorithm>

namespace symscene {

PointIndices SurfacePart::in_whole(const PointIndices& local) const {
  PointIndices whole;
  whole.reserve(local.size());
  for (const Index k : local) whole.push_back(original[k]);
  return whole;
}

PointIndices SurfacePart::in_part(const PointIndices& whole) const {
  PointIndices local;
  for (const Index i : whole) {
    const auto place = std::lower_bound(original.begin(), original.end(), i);
    if (place != original.end() && *place == i)
      local.push_back(static_cast<Index>(place - original.begin()));
  }
  return local;
}

PartPlaces::PartPlaces(std::size_t count, const PointIndices& points) : place_(count, absent) {
  for (Index k = 0; k < points.size(); ++k) place_[points[k]] = k;
}

}  // namespace symscene
