#include "symmetry/plane_quality.hpp"

#include "symmetry/point_residuals.hpp"
#include "symmetry/score_range.hpp"

namespace symscene {

PlaneQuality plane_quality(const IndexedCloud& target, std::span<const Index> members,
                           const ReflectionPlane& plane, const DistanceField& field,
                           const ReflectionalDetectionOptions& options) {
  if (members.empty()) return {0.0, 0.0, 1.0};
  const std::vector<Correspondence> matches =
      one_to_one(reflect_onto(target, members, plane, options.scoring));
  const ScoreRange angles = angle_range(options);
  double agreement = 0.0;
  for (const Correspondence& match : matches)
    agreement += 1.0 - double{angles(safe_acos(match.cosine))};  // Eq. 3.9
  const PlaneReflector reflector(plane);
  const ScoreRange occlusions = occlusion_range(options);
  double occlusion = 0.0;
  for (const Index i : members) {
    occlusion +=
        double{occlusions(field.at(reflector.point(target.cloud.position(i))))};  // Eq. 4.7
  }
  const auto count = static_cast<double>(members.size());
  const double symmetry = matches.empty() ? 0.0 : agreement / static_cast<double>(matches.size());
  return {symmetry, agreement / count, occlusion / count};  // Eqs. 3.9, 3.10, 4.12
}

}  // namespace symscene
