#include "segment_distance.hpp"

#include <algorithm>

namespace symscene {

double segment_distance(const Eigen::Vector3d& point, const Eigen::Vector3d& begin,
                        const Eigen::Vector3d& end) {
  const Eigen::Vector3d along = end - begin;
  const double squared = along.squaredNorm();
  const double share =
      squared > 0.0 ? std::clamp((point - begin).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - begin - share * along).norm();
}

double capsule_distance(const Capsule& a, const Capsule& b) {
  // Segments are nearest at an end of one of them, or between their lines' nearest points.
  double least = std::min(
      {segment_distance(a.begin, b.begin, b.end), segment_distance(a.end, b.begin, b.end),
       segment_distance(b.begin, a.begin, a.end), segment_distance(b.end, a.begin, a.end)});
  const Eigen::Vector3d u = a.end - a.begin;
  const Eigen::Vector3d v = b.end - b.begin;
  const Eigen::Vector3d w = a.begin - b.begin;
  const double uu = u.squaredNorm();
  const double uv = u.dot(v);
  const double vv = v.squaredNorm();
  const double determinant = uu * vv - uv * uv;
  if (determinant > 1e-12 * uu * vv) {
    const double s = (uv * v.dot(w) - vv * u.dot(w)) / determinant;
    const double t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
    if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)
      least = std::min(least, (w + s * u - t * v).norm());
  }
  return least - a.radius - b.radius;
}

Capsule transformed(const Capsule& capsule, const Eigen::Isometry3d& T) {
  return {T * capsule.begin, T * capsule.end, capsule.radius};
}

}  // namespace symscene
