#include "motion/free_arcs.hpp"

#include <cmath>

namespace symscene {

bool arcs_are_free(
    const JointPath& path,
    const std::function<bool(const Eigen::VectorXd&, const Eigen::VectorXd&)>& is_free) {
  constexpr double chord = 0.1;  // of an arc; it leaves the chord by 0.1 % of the radius [rad]
  for (const PathSegment& segment : path.segments()) {
    if (segment.is_line()) continue;
    const double chords = std::ceil(segment.length / segment.radius / chord);
    for (double i = 0.0; i < chords; i += 1.0) {
      if (!is_free(segment.position(segment.length * i / chords),
                   segment.position(segment.length * (i + 1.0) / chords)))
        return false;
    }
  }
  return true;
}

}  // namespace symscene
