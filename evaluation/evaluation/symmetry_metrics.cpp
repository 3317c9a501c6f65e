#include "symscene/evaluation/symmetry_metrics.hpp"

#include <algorithm>
#include <cmath>

#include "symmetry_targets.hpp"

namespace symscene {
namespace {

bool within(const SymmetryDifference& d, const SymmetryTolerance& tolerance) {
  return d.angle < tolerance.angle && d.distance < tolerance.distance;
}

/// A true symmetry with the point at which differences from it are taken.
template <class Symmetry>
struct SymmetryTarget {
  Symmetry symmetry;
  Eigen::Vector3d centroid;
  bool strict = true;
  bool any_direction = false;  ///< of a sphere: any axis through the centroid is right
};

template <class Symmetry>
SymmetryDifference difference_from(const SymmetryTarget<Symmetry>& target, const Symmetry& found) {
  if (!target.any_direction) return difference(target.symmetry, found, target.centroid);
  return {0.0, (found.project(target.centroid) - target.centroid).norm()};
}

/// A found symmetry within the tolerance of a strict target.
struct Claim {
  std::size_t target = 0;
  std::size_t found = 0;
  double distance = 0.0;
};

/// Each strict target gets the nearest found symmetry within the tolerance (section 3.6.1), and
/// each found symmetry is assigned to at most one target. The others are wrong unless they are
/// close to a weak target or `excused(symmetry)`.
template <class Symmetry, class Excused>
SymmetryMatch match(const std::vector<SymmetryTarget<Symmetry>>& targets,
                    std::span<const Symmetry> found, const SymmetryTolerance& tolerance,
                    const Excused& excused) {
  SymmetryMatch result;
  std::vector<Claim> claims;
  std::vector<bool> near_weak(found.size(), false);
  for (const SymmetryTarget<Symmetry>& target : targets) {
    for (std::size_t f = 0; f < found.size(); ++f) {
      const SymmetryDifference d = difference_from(target, found[f]);
      if (!within(d, tolerance)) continue;
      if (target.strict) claims.push_back({result.truth_met.size(), f, d.distance});
      if (!target.strict || target.any_direction) near_weak[f] = true;
    }
    if (target.strict) result.truth_met.push_back(false);
  }
  std::stable_sort(claims.begin(), claims.end(),
                   [](const Claim& a, const Claim& b) { return a.distance < b.distance; });
  std::vector<bool> used(found.size(), false);
  for (const Claim& claim : claims) {
    if (result.truth_met[claim.target] || used[claim.found]) continue;
    result.truth_met[claim.target] = true;
    used[claim.found] = true;
    ++result.right;
  }
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (used[f]) continue;
    ++(near_weak[f] || excused(found[f]) ? result.neither : result.wrong);
  }
  return result;
}

bool follows_from_rotation(const ReflectionPlane& plane, const TrueObject& object,
                           const SymmetryTolerance& tolerance) {
  if (object.sphere && std::abs(plane.signed_distance(object.centroid)) < tolerance.distance) {
    return true;
  }
  return std::any_of(object.rotational.begin(), object.rotational.end(), [&](const TrueAxis& own) {
    return within(difference(plane, own.axis, object.centroid), tolerance);
  });
}

/// A true plane that follows from a rotation of its object is one of infinitely many: it need not
/// be found. Ground truth is exact, so this test uses the default tolerance.
bool has_to_be_found(const TruePlane& own, const TrueObject& object) {
  return own.strict && !follows_from_rotation(own.plane, object, SymmetryTolerance{});
}

}  // namespace

std::vector<std::size_t> axis_targets(const SceneTruth& truth) {
  std::vector<std::size_t> counts;
  for (const TrueObject& object : truth.objects) {
    const auto strict = std::count_if(object.rotational.begin(), object.rotational.end(),
                                      [](const TrueAxis& own) { return own.strict; });
    counts.push_back(object.sphere ? 1 : static_cast<std::size_t>(strict));
  }
  return counts;
}

std::vector<std::size_t> plane_targets(const SceneTruth& truth) {
  std::vector<std::size_t> counts;
  for (const TrueObject& object : truth.objects) {
    const auto strict =
        std::count_if(object.reflectional.begin(), object.reflectional.end(),
                      [&](const TruePlane& own) { return has_to_be_found(own, object); });
    counts.push_back(static_cast<std::size_t>(strict));
  }
  return counts;
}

bool is_symmetry_of(const TrueObject& object, const RotationAxis& axis,
                    const SymmetryTolerance& tolerance) {
  if (object.sphere && axis.distance(object.centroid) < tolerance.distance) return true;
  return std::any_of(object.rotational.begin(), object.rotational.end(), [&](const TrueAxis& own) {
    return within(difference(own.axis, axis, object.centroid), tolerance);
  });
}

bool is_symmetry_of(const TrueObject& object, const ReflectionPlane& plane,
                    const SymmetryTolerance& tolerance) {
  if (follows_from_rotation(plane, object, tolerance)) return true;
  return std::any_of(object.reflectional.begin(), object.reflectional.end(),
                     [&](const TruePlane& own) {
                       return within(difference(own.plane, plane, object.centroid), tolerance);
                     });
}

SymmetryMatch match_axes(const SceneTruth& truth, std::span<const RotationAxis> found,
                         const SymmetryTolerance& tolerance) {
  std::vector<SymmetryTarget<RotationAxis>> targets;
  for (const TrueObject& object : truth.objects) {
    if (object.sphere) {
      targets.push_back({{}, object.centroid, true, true});
      continue;
    }
    for (const TrueAxis& own : object.rotational) {
      targets.push_back({own.axis, object.centroid, own.strict});
    }
  }
  return match<RotationAxis>(targets, found, tolerance, [](const RotationAxis&) { return false; });
}

SymmetryMatch match_planes(const SceneTruth& truth, std::span<const ReflectionPlane> found,
                           const SymmetryTolerance& tolerance) {
  std::vector<SymmetryTarget<ReflectionPlane>> targets;
  for (const TrueObject& object : truth.objects) {
    for (const TruePlane& own : object.reflectional) {
      targets.push_back({own.plane, object.centroid, has_to_be_found(own, object)});
    }
  }
  return match<ReflectionPlane>(targets, found, tolerance, [&](const ReflectionPlane& plane) {
    return std::any_of(truth.objects.begin(), truth.objects.end(), [&](const TrueObject& object) {
      return follows_from_rotation(plane, object, tolerance);
    });
  });
}

std::vector<RotationAxis> all_axes(const std::vector<SceneObject>& objects) {
  std::vector<RotationAxis> axes;
  for (const SceneObject& object : objects) {
    for (const ObjectAxis& own : object.rotational) axes.push_back(own.axis);
  }
  return axes;
}

std::vector<ReflectionPlane> all_planes(const std::vector<SceneObject>& objects) {
  std::vector<ReflectionPlane> planes;
  for (const SceneObject& object : objects) {
    for (const ObjectPlane& own : object.reflectional) planes.push_back(own.plane);
  }
  return planes;
}

}  // namespace symscene
