#include "symscene/simulation/tabletop.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "footprint.hpp"
#include "simulation/household_object.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/error.hpp"
#include "tabletop_parts.hpp"

namespace symscene {
namespace {

constexpr double contact_gap = TabletopOptions::contact_gap;

/// Where an object would stand, in the table's frame.
struct Place {
  double yaw = 0.0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Index supporter = PlacedObject::on_table;
};

/// An object at its place, with the quantities of the collision check.
struct Standing {
  HouseholdObject object;
  Place place;
  Footprint outline;
  double low = 0.0;
  double high = 0.0;
  bool carries = false;
};

class Arranger {
 public:
  explicit Arranger(const TabletopOptions& options) : options_(options), random_(options.seed) {}

  std::vector<Standing> arrange() {
    for (int i = 0; i < options_.objects; ++i) {
      if (!standing_.empty() && random_.chance(options_.stacked) && try_to_stack()) continue;
      push_to_the_others(make_household_object(random_object_kind(random_), random_));
    }
    center();
    return std::move(standing_);
  }

 private:
  double random_yaw() { return random_.uniform(0.0, 2.0 * std::numbers::pi); }

  void put(HouseholdObject object, const Place& place) {
    Footprint outline = moved(object.footprint, place.yaw, place.position.head<2>());
    const double low = place.position.z();
    const double high = low + object.height;
    if (place.supporter != PlacedObject::on_table) standing_[place.supporter].carries = true;
    standing_.push_back({std::move(object), place, std::move(outline), low, high, false});
  }

  /// Whether an object with this outline and height range keeps `gap` from all objects but its
  /// supporter.
  bool is_free(const Footprint& outline, double low, double high, double gap,
               Index supporter) const {
    for (Index i = 0; i < standing_.size(); ++i) {
      const Standing& other = standing_[i];
      if (i == supporter || low >= other.high || high <= other.low) continue;
      if (separation(outline, other.outline) < gap) return false;
    }
    return true;
  }

  /// Slides an object in from three random sides and takes the place nearest to the middle.
  void push_to_the_others(HouseholdObject object) {
    const double gap = random_.chance(options_.touching)
                           ? contact_gap
                           : random_.uniform(options_.min_gap, options_.max_gap);
    Place best;
    double best_distance = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 3; ++side) {
      Place place;
      place.yaw = random_yaw();
      const Eigen::Vector2d position = slide_in(object, place.yaw, gap);
      if (position.norm() >= best_distance) continue;
      best_distance = position.norm();
      place.position.head<2>() = position;
      best = place;
    }
    put(std::move(object), best);
  }

  /// Moves from far outside towards a point near the middle until an object is in the way.
  Eigen::Vector2d slide_in(const HouseholdObject& object, double yaw, double gap) {
    const double heading = random_yaw();
    const Eigen::Vector2d inward(-std::cos(heading), -std::sin(heading));
    const Eigen::Vector2d goal(random_.uniform(-0.05, 0.05), random_.uniform(-0.05, 0.05));
    const auto at = [&](double way) -> Eigen::Vector2d { return goal - way * inward; };
    const auto free_at = [&](double way) {
      return is_free(moved(object.footprint, yaw, at(way)), 0.0, object.height, gap,
                     PlacedObject::on_table);
    };
    constexpr double step = 0.01;
    double free_way = 1.5;
    while (free_way > 0.0 && free_at(free_way - step)) free_way -= step;
    double blocked_way = free_way - step;
    for (int halving = 0; halving < 6 && free_way > 0.0; ++halving) {
      const double middle = 0.5 * (free_way + blocked_way);
      (free_at(middle) ? free_way : blocked_way) = middle;
    }
    return at(free_way);
  }

  bool try_to_stack() {
    constexpr int tries = 12;
    for (int attempt = 0; attempt < tries; ++attempt) {
      const Index below = random_.below(static_cast<std::uint32_t>(standing_.size()));
      HouseholdObject object =
          make_household_object(random_object_kind(random_), random_, random_.uniform(0.5, 1.0));
      if (standing_[below].carries) continue;
      const std::optional<Place> place = standing_[below].object.cavity
                                             ? place_inside(object, below)
                                             : place_on_top(object, below);
      if (!place) continue;
      put(std::move(object), *place);
      return true;
    }
    return false;
  }

  /// Inside a bowl: the whole outline over the bowl's flat floor.
  std::optional<Place> place_inside(const HouseholdObject& object, Index below) {
    const Standing& bowl = standing_[below];
    double reach = 0.0;
    for (const Eigen::Vector2d& p : object.footprint) reach = std::max(reach, p.norm());
    const double room = bowl.object.cavity->radius - contact_gap - reach;
    if (room < 0.0) return std::nullopt;
    return checked(object, below, bowl.object.cavity->floor, room);
  }

  /// On a flat top, which must support most of the outline.
  std::optional<Place> place_on_top(const HouseholdObject& object, Index below) {
    constexpr double supported = 0.7;
    const double top = standing_[below].object.top_radius;
    if (top == 0.0) return std::nullopt;
    double reach = 0.0;
    for (const Eigen::Vector2d& p : object.footprint) reach = std::max(reach, p.norm());
    const double room = top - supported * reach;
    if (room < 0.0) return std::nullopt;
    return checked(object, below, standing_[below].object.height, room);
  }

  std::optional<Place> checked(const HouseholdObject& object, Index below, double rise,
                               double room) {
    const Standing& support = standing_[below];
    Place place;
    place.yaw = random_yaw();
    place.supporter = below;
    const double heading = random_yaw();
    const double shift = room * std::sqrt(random_.uniform());
    place.position = support.place.position +
                     Eigen::Vector3d(shift * std::cos(heading), shift * std::sin(heading), rise);
    const double low = place.position.z();
    const double high = low + object.height;
    if (high > options_.max_stack) return std::nullopt;
    const Footprint outline = moved(object.footprint, place.yaw, place.position.head<2>());
    if (!is_free(outline, low, high, contact_gap, below)) return std::nullopt;
    return place;
  }

  /// Moves the middle of the bounding box of the outlines to the origin.
  void center() {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
    Eigen::Vector2d high = -low;
    for (const Standing& s : standing_) {
      for (const Eigen::Vector2d& p : s.outline) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
    for (Standing& s : standing_) s.place.position.head<2>() -= 0.5 * (low + high);
  }

  const TabletopOptions& options_;
  Random random_;
  std::vector<Standing> standing_;
};

Eigen::Isometry3d random_frame(Random& random) {
  Eigen::Vector4d q;
  for (int i = 0; i < 4; ++i) q[i] = random.normal();
  Eigen::Isometry3d frame(Eigen::Quaterniond(q.normalized()));
  for (int axis = 0; axis < 3; ++axis) frame.translation()[axis] = random.uniform(-1.0, 1.0);
  return frame;
}

}  // namespace

void TabletopOptions::validate() const {
  check_fields(*this);
  require_option(max_gap >= min_gap, "max_gap", "at least min_gap", max_gap);
}

Plane Tabletop::plane() const {
  const Eigen::Vector3d normal = T_world_table.linear().col(2);
  return {normal, -normal.dot(T_world_table.translation())};
}

Tabletop empty_tabletop(const TabletopOptions& options) {
  Tabletop tabletop;
  tabletop.table = options.table;
  if (options.random_frame) {
    Random random(options.seed, 1);
    tabletop.T_world_table = random_frame(random);
  }
  return tabletop;
}

Tabletop arrange_tabletop(const TabletopOptions& options) {
  options.validate();
  Tabletop tabletop = empty_tabletop(options);
  for (Standing& standing : Arranger(options).arrange()) {
    Eigen::Isometry3d T_table_object(
        Eigen::AngleAxisd(standing.place.yaw, Eigen::Vector3d::UnitZ()));
    T_table_object.pretranslate(standing.place.position);
    ObjectModel& model = standing.object;
    tabletop.objects.push_back(
        {std::move(model), tabletop.T_world_table * T_table_object, standing.place.supporter});
  }
  return tabletop;
}

TriangleMesh world_mesh(const PlacedObject& placed) {
  return transformed(placed.object.mesh, placed.T_world_object);
}

TrueObject true_object(const PlacedObject& placed) {
  const Eigen::Isometry3d& T = placed.T_world_object;
  TrueObject truth;
  truth.name = placed.object.name;
  truth.sphere = placed.object.sphere;
  truth.centroid = T * volume_centroid(placed.object.mesh);
  for (const TrueAxis& own : placed.object.rotational) {
    truth.rotational.push_back({{T * own.axis.point, T.linear() * own.axis.direction}, own.strict});
  }
  for (const TruePlane& own : placed.object.reflectional) {
    truth.reflectional.push_back(
        {{T * own.plane.point, T.linear() * own.plane.normal}, own.strict});
  }
  return truth;
}

}  // namespace symscene
