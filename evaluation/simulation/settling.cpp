#include "symscene/simulation/settling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "convex_parts_cache.hpp"
#include "core/random.hpp"
#include "core/surface_sampling.hpp"
#include "paint.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/error.hpp"
#include "tabletop_parts.hpp"

namespace symscene {
namespace {

constexpr double check_interval = 0.05;  // simulated between two checks for rest [s]
constexpr std::uint64_t drop_stream = std::uint64_t{1}
                                      << 32U;  // distinct from the streams of the frames

Points in_pose(const Points& points, const Eigen::Isometry3d& pose) {
  const Eigen::Isometry3f T = pose.cast<float>();
  return (points * T.linear().transpose()).rowwise() + T.translation().transpose();
}

double thickness(const ObjectModel& model) {
  return bounding_box(model.mesh.vertices).extent().minCoeff();
}

/// Objects that fall onto the table and rest there.
class Pile {
 public:
  Pile(std::span<const ObjectModel> models, const DropOptions& options,
       std::span<const ConvexParts* const> parts)
      : options_(options), world_(parts, options.physics) {
    constexpr std::size_t samples = 1500;
    for (const ObjectModel& model : models)
      surfaces_.push_back(sample_surface(model.mesh, samples).positions);
  }

  /// Drops an object in this orientation and at this place, as low as the objects below it allow.
  void drop(std::size_t i, const Eigen::Isometry3d& T_table_object) {
    const Points falling = in_pose(surfaces_[i], T_table_object);
    const double rise = top_under(falling) + options_.drop_height - falling.col(2).minCoeff();
    world_.put(i, Eigen::Translation3d(0, 0, rise) * T_table_object);
  }

  /// Simulates until all objects are at rest, but not for longer than `seconds`.
  void wait(double seconds) {
    int still_checks = 0;
    for (double t = 0.0; t < seconds && still_checks < 3; t += check_interval) {
      world_.advance(check_interval);
      still_checks = all_still() ? still_checks + 1 : 0;
    }
  }

  void take_away(std::size_t i) { world_.take_away(i); }
  bool is_there(std::size_t i) const { return world_.is_there(i); }
  Eigen::Isometry3d pose(std::size_t i) const { return world_.pose(i); }
  bool is_still(std::size_t i) const { return world_.speed(i) <= options_.still_speed; }

  bool is_on_table(std::size_t i) const {
    const Points surface = in_pose(surfaces_[i], world_.pose(i));
    const Eigen::Vector3f middle = surface.colwise().mean().transpose();
    return middle.head<2>().norm() < options_.area && surface.col(2).minCoeff() > -0.01F;
  }

  bool rests_well(std::size_t i) const {
    return is_on_table(i) && is_still(i) && world_.penetration(i) <= options_.max_penetration;
  }

  std::size_t size() const { return surfaces_.size(); }

 private:
  bool all_still() const {
    for (std::size_t i = 0; i < size(); ++i) {
      if (is_there(i) && is_on_table(i) && !is_still(i)) return false;
    }
    return true;
  }

  /// The highest point of the objects inside the box around `falling`, seen from above. [m]
  double top_under(const Points& falling) const {
    const Box box = bounding_box(falling).padded(0.003F);
    float top = 0.0F;
    for (std::size_t i = 0; i < size(); ++i) {
      if (!is_there(i)) continue;
      const Points lying = in_pose(surfaces_[i], world_.pose(i));
      for (Eigen::Index k = 0; k < lying.rows(); ++k) {
        const bool under = lying(k, 0) > box.min.x() && lying(k, 0) < box.max.x() &&
                           lying(k, 1) > box.min.y() && lying(k, 1) < box.max.y();
        if (under) top = std::max(top, lying(k, 2));
      }
    }
    return top;
  }

  const DropOptions& options_;
  PhysicsWorld world_;
  std::vector<Points> surfaces_;
};

/// The orientation and place, but for the height, from which an object falls.
Eigen::Isometry3d random_pose(const ObjectModel& model, const DropOptions& options,
                              Random& random) {
  const auto turn = [&] { return random.uniform(0.0, 2.0 * std::numbers::pi); };
  Eigen::Quaterniond orientation;
  if (random.chance(options.upright)) {
    const double heading = turn();
    const Eigen::Vector3d axis(std::cos(heading), std::sin(heading), 0.0);
    const double tilt = options.tilt * random.normal();
    const double spin = turn();
    orientation = Eigen::AngleAxisd(tilt, axis) * Eigen::AngleAxisd(spin, Eigen::Vector3d::UnitZ());
  } else {
    Eigen::Vector4d q;
    for (int i = 0; i < 4; ++i) q[i] = random.normal();
    orientation = Eigen::Quaterniond(q.normalized());
  }
  const double distance = options.spread * std::sqrt(random.uniform());
  const double heading = turn();
  const Eigen::Vector3d place(distance * std::cos(heading), distance * std::sin(heading), 0.0);
  const Box box = bounding_box(model.mesh.vertices);
  const Eigen::Vector3d middle = (0.5F * (box.min + box.max)).cast<double>();
  return Eigen::Translation3d(place) * orientation * Eigen::Translation3d(-middle);
}

/// The models that can be dropped and are thick enough to be seen.
std::vector<const ObjectModel*> usable_models(std::span<const ObjectModel> models,
                                              double min_thickness,
                                              std::vector<std::string>& warnings) {
  std::vector<const ObjectModel*> usable;
  for (const ObjectModel& model : models) {
    if (!is_solid(model.mesh)) {
      warnings.push_back(fmt::format("{} is not a solid and is not used", model.name));
    } else if (thickness(model) >= min_thickness) {
      usable.push_back(&model);
    }
  }
  if (usable.empty()) {
    throw InputError("the meshes", fmt::format("a solid {} m thick or more", min_thickness),
                     fmt::format("none in {}", models.size()));
  }
  return usable;
}

/// Draws `count` models, the largest first, and paints those without colours.
std::vector<ObjectModel> drawn_models(const std::vector<const ObjectModel*>& usable, int count,
                                      Random& random) {
  std::vector<ObjectModel> chosen;
  for (auto left = usable; chosen.size() < static_cast<std::size_t>(count);) {
    if (left.empty()) left = usable;
    const std::size_t k = random.below(static_cast<std::uint32_t>(left.size()));
    chosen.push_back(*left[k]);
    TriangleMesh& mesh = chosen.back().mesh;
    if (mesh.colors.rows() == 0) mesh.colors = paint(mesh.vertices, random);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
  }
  const auto size = [](const ObjectModel& model) {
    return bounding_box(model.mesh.vertices).extent().norm();
  };
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](const ObjectModel& a, const ObjectModel& b) { return size(a) > size(b); });
  return chosen;
}

/// Drops the objects that are not on the table, one after the other.
void drop_missing(Pile& pile, std::span<const ObjectModel> models, const DropOptions& options,
                  Random& random) {
  for (std::size_t i = 0; i < pile.size(); ++i) {
    if (pile.is_there(i)) continue;
    pile.drop(i, random_pose(models[i], options, random));
    pile.wait(options.fall_time);
  }
  pile.wait(options.settle_time);
}

/// Takes away the objects that do not rest well. Returns whether there were any.
bool clear_away(Pile& pile) {
  bool any = false;
  for (std::size_t i = 0; i < pile.size(); ++i) {
    if (!pile.is_there(i) || pile.rests_well(i)) continue;
    pile.take_away(i);
    any = true;
  }
  return any;
}

/// Places the objects where they rest, with the middle of their bounding box at the origin of the
/// table.
void put_on_table(const Pile& pile, std::vector<ObjectModel> models, Tabletop& tabletop) {
  Box box;
  for (std::size_t i = 0; i < pile.size(); ++i) {
    if (!pile.is_there(i)) continue;
    const Box own = bounding_box(in_pose(models[i].mesh.vertices, pile.pose(i)));
    box.min = box.min.cwiseMin(own.min);
    box.max = box.max.cwiseMax(own.max);
  }
  Eigen::Vector3d middle = (0.5F * (box.min + box.max)).cast<double>();
  middle.z() = 0.0;
  for (std::size_t i = 0; i < pile.size(); ++i) {
    if (!pile.is_there(i)) {
      tabletop.warnings.push_back(
          fmt::format("{} found no place to rest and is left out", models[i].name));
      continue;
    }
    const Eigen::Isometry3d T_table_object = Eigen::Translation3d(-middle) * pile.pose(i);
    tabletop.objects.push_back(
        {std::move(models[i]), tabletop.T_world_table * T_table_object, PlacedObject::on_table});
  }
}

}  // namespace

void DropOptions::validate() const {
  check_fields(*this);
  require_option(area > spread, "area", "more than spread", area);
}

Tabletop drop_tabletop(std::span<const ObjectModel> models, const TabletopOptions& tabletop,
                       const DropOptions& options) {
  tabletop.validate();
  options.validate();
  Random random(tabletop.seed, drop_stream);
  Tabletop result = empty_tabletop(tabletop);
  std::vector<ObjectModel> chosen = drawn_models(
      usable_models(models, options.min_thickness, result.warnings), tabletop.objects, random);
  ConvexPartsCache cache(options.parts);
  Pile pile(chosen, options, cache.of(chosen));
  bool is_complete = false;
  for (int attempt = 0; attempt < options.attempts && !is_complete; ++attempt) {
    drop_missing(pile, chosen, options, random);
    is_complete = !clear_away(pile);
  }
  // Objects that lay on one that was taken away may have moved.
  while (!is_complete) {
    pile.wait(options.settle_time);
    is_complete = !clear_away(pile);
  }
  put_on_table(pile, std::move(chosen), result);
  return result;
}

Tabletop settle(std::span<const ObjectModel> models, std::span<const Eigen::Isometry3d> poses,
                const DropOptions& options) {
  options.validate();
  ConvexPartsCache cache(options.parts);
  const std::vector<const ConvexParts*> parts = cache.of(models);
  PhysicsWorld world(parts, options.physics);
  for (std::size_t i = 0; i < models.size(); ++i) world.put(i, poses[i]);
  world.advance(options.settle_time);
  Tabletop result;
  for (std::size_t i = 0; i < models.size(); ++i)
    result.objects.push_back({models[i], world.pose(i), PlacedObject::on_table});
  return result;
}

}  // namespace symscene
