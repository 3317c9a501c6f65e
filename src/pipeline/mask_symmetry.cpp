#include "pipeline/mask_symmetry.hpp"

#include <algorithm>
#include <cmath>

namespace symscene {
namespace {

constexpr float cell_size = 0.01F;

/// What becomes of an object's points under a plane, as shares of them; the rest is hidden, where
/// no camera saw.
struct ImageShares {
  double matched = 0.0;       ///< the image lies on the surface
  double contradicted = 0.0;  ///< it lies off the surface, in space that was seen empty or inside
};

class ImageTest {
 public:
  ImageTest(const PointCloud& points, const DistanceField& field,
            const ObjectSymmetryBounds& bounds)
      : points_(points),
        field_(field),
        bounds_(bounds),
        cells_(points.positions, cell_size),
        sample_(evenly_spread(points.size(), images)),
        shell_(select(points, evenly_spread(points.size(), shell_points))),
        // The thinner the shell, the farther its points are apart.
        shell_gap_(0.008F *
                   std::sqrt(std::max(1.0F, static_cast<float>(points.size()) / shell_points))) {}

  ImageShares operator()(const ReflectionPlane& plane) const {
    const PlaneReflector reflector(plane);
    double matched = 0.0, contradicted = 0.0, count = 0.0;
    for (const Index i : sample_) {
      if (std::abs(reflector.signed_distance(points_.position(i))) <
          static_cast<float>(bounds_.min_plane_distance))
        continue;
      count += 1.0;
      const Eigen::Vector3f p = reflector.point(points_.position(i));
      const Eigen::Vector3f n = reflector.direction(points_.normal(i));
      const Meeting meeting = meet(p, n);
      matched += meeting == Meeting::agrees ? 1.0 : 0.0;
      contradicted += meeting == Meeting::disagrees || (meeting == Meeting::none &&
                                                        (field_.at(p) > empty || is_buried(p, n)))
                          ? 1.0
                          : 0.0;
    }
    if (count == 0.0) return {};
    return {matched / count, contradicted / count};
  }

 private:
  enum class Meeting { none, agrees, disagrees };

  static constexpr Index images = 300;
  static constexpr Index shell_points = 400;
  static constexpr float empty = 0.01F;      // into space that was seen empty [m]
  static constexpr float agree = 0.008F;     // between an image and the point that it meets [m]
  static constexpr float disagree = 0.005F;  // so near, an image has to agree [m]

  Meeting meet(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const {
    const auto min_cosine = static_cast<float>(std::cos(bounds_.max_image_angle));
    const auto max_offset = static_cast<float>(bounds_.max_image_offset);
    Meeting meeting = Meeting::none;
    cells_.for_each_within(p, agree, [&](Index j, float squared_distance) {
      const Eigen::Vector3f m = points_.normal(j);
      if (m.dot(n) > min_cosine && std::abs(m.dot(p - points_.position(j))) < max_offset) {
        meeting = Meeting::agrees;
      } else if (meeting == Meeting::none && squared_distance < disagree * disagree) {
        meeting = Meeting::disagrees;
      }
    });
    return meeting;
  }

  /// Whether it lies behind a part of the surface that faces the same way.
  bool is_buried(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const {
    constexpr float shallow = 0.004F, deep = 0.12F;  // [m]
    constexpr float same_way = 0.7F;                 // cosine
    for (Index k = 0; k < shell_.size(); ++k) {
      const Eigen::Vector3f to = shell_.position(k) - p;
      const float height = to.dot(n);
      if (height < shallow || height > deep || shell_.normal(k).dot(n) < same_way) continue;
      if (to.squaredNorm() - height * height < shell_gap_ * shell_gap_) return true;
    }
    return false;
  }

  const PointCloud& points_;
  const DistanceField& field_;
  const ObjectSymmetryBounds& bounds_;
  CellList cells_;
  PointIndices sample_;
  PointCloud shell_;
  float shell_gap_;
};

std::vector<ScoredAxis> axes_of(const SceneProposals& proposals, const PointCloud& points,
                                const PipelineOptions& options,
                                const std::vector<RotationAxis>& proposed) {
  const ObjectSymmetryBounds& bounds = options.object_symmetry;
  std::vector<ScoredAxis> fits;
  for (const RotationAxis& axis : proposed) {
    const RotationalScores scores =
        rotational_scores(points, axis, proposals.field, options.rotational_detection);
    if (scores.symmetry < bounds.max_axis_misfit && scores.occlusion < bounds.max_axis_occlusion &&
        scores.perpendicularity < options.rotational_detection.max_perpendicularity &&
        scores.coverage > bounds.min_axis_coverage)
      fits.push_back({axis, scores.symmetry});
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const ScoredAxis& a, const ScoredAxis& b) { return a.score < b.score; });
  // A body with two axes is a ball, and of that one axis says as much as many.
  fits.resize(std::min<std::size_t>(fits.size(), 1));
  return fits;
}

/// How far a plane is from explaining all points: what is hidden speaks neither for nor against it.
double misfit(const ImageShares& shares) {
  return 0.75 * shares.contradicted + 0.25 * (1.0 - shares.matched);
}

/// Whether a body can have one more mirror beside those that it has. Two parallel ones would make
/// it endless, and two that are not at right angles make it a prism of many sides, which needs
/// evidence.
bool is_compatible(const ScoredPlane& plane, const std::vector<ScoredPlane>& known,
                   const ObjectSymmetryBounds& bounds) {
  return std::all_of(known.begin(), known.end(), [&](const ScoredPlane& other) {
    const double angle = line_angle(plane.plane.normal, other.plane.normal);
    if (angle < bounds.same_plane_angle) return false;
    return angle > 0.5 * std::numbers::pi - bounds.right_angle_tolerance ||
           plane.score < bounds.max_oblique_misfit;
  });
}

std::vector<ScoredPlane> planes_of(const SceneProposals& proposals, const PointCloud& points,
                                   const PipelineOptions& options, const SceneObject& object,
                                   const std::vector<ReflectionPlane>& proposed) {
  const ObjectSymmetryBounds& bounds = options.object_symmetry;
  const ImageTest images_of(points, proposals.field, bounds);
  std::vector<ScoredPlane> fits;
  for (const ReflectionPlane& plane : proposed) {
    const bool implied =
        std::any_of(object.rotational.begin(), object.rotational.end(), [&](const ScoredAxis& own) {
          const SymmetryDifference apart = difference(plane, own.axis, object.centroid);
          return apart.angle < bounds.plane_in_axis_angle &&
                 apart.distance < bounds.plane_in_axis_distance;
        });
    if (implied) continue;
    const ImageShares shares = images_of(plane);
    const double decided = shares.matched + shares.contradicted;
    if (shares.matched > bounds.min_plane_matched &&
        shares.contradicted < bounds.max_plane_contradicted * decided)
      fits.push_back({plane, misfit(shares)});
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const ScoredPlane& a, const ScoredPlane& b) { return a.score < b.score; });
  std::vector<ScoredPlane> distinct;
  for (const ScoredPlane& fit : fits) {
    if (is_compatible(fit, distinct, bounds)) distinct.push_back(fit);
  }
  return distinct;
}

/// The detectors' options for points that are a whole object: what is accepted is decided later,
/// and points near a plane count too.
PipelineOptions for_whole_objects(PipelineOptions options) {
  const ObjectSymmetryBounds& bounds = options.object_symmetry;
  RotationalDetectionOptions& axes = options.rotational_detection;
  axes.max_symmetry_score = bounds.max_axis_misfit;
  axes.max_occlusion_score = bounds.max_axis_occlusion;
  axes.min_coverage = bounds.min_axis_coverage;
  ReflectionalDetectionOptions& planes = options.reflectional_detection;
  planes.min_symmetry_score = 0.7;
  planes.min_inlier_score = bounds.min_plane_matched;
  planes.max_occlusion_score = 0.05;
  for (CorrespondenceOptions* matching : {&planes.fit.matching, &planes.scoring})
    matching->min_plane_distance = bounds.min_plane_distance;
  return options;
}

}  // namespace

void find_symmetries(const SceneProposals& proposals, const PipelineOptions& given,
                     SceneObject& object) {
  const PipelineOptions options = for_whole_objects(given);
  const PointCloud points = select(proposals.cloud, object.points);
  const std::vector<PointIndices> whole{evenly_spread(points.size(), points.size())};
  std::optional<Eigen::Vector3d> up;
  if (proposals.table) up = proposals.table->normal;
  std::vector<RotationAxis> axes;
  if (options.rotational_stream) {
    for (const ScoredAxis& own : object.rotational) axes.push_back(own.axis);
    for (const RotationalCandidate& candidate :
         detect_rotational(points, whole, proposals.field, up, options.rotational_detection)
             .candidates)
      axes.push_back(candidate.axis);
  }
  object.rotational = axes_of(proposals, points, options, axes);
  std::vector<ReflectionPlane> planes;
  for (const ScoredPlane& own : object.reflectional) planes.push_back(own.plane);
  for (const ReflectionalCandidate& candidate :
       detect_reflectional(points, whole, proposals.field, up, options.reflectional_detection)
           .candidates)
    planes.push_back(candidate.plane);
  object.reflectional = planes_of(proposals, points, options, object, planes);
}

}  // namespace symscene
