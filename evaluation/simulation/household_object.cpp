#include "simulation/household_object.hpp"

#include <array>
#include <cmath>

#include "footprint.hpp"
#include "paint.hpp"
#include "simulation/shapes.hpp"

namespace symscene {
namespace {

constexpr int segments = 96;        // a bowl of 14 cm is round to 0.1 mm
constexpr double max_edge = 0.008;  // fine enough to carry the paint [m]

TruePlane plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, bool strict) {
  return {{point, normal.normalized()}, strict};
}

/// An object of a kind with its mesh, outline and height.
HouseholdObject standing(ObjectKind kind, TriangleMesh mesh) {
  HouseholdObject object;
  object.name = to_string(kind);
  object.footprint = convex_outline(mesh.vertices);
  object.height = mesh.vertices.col(2).maxCoeff();
  object.mesh = std::move(mesh);
  return object;
}

HouseholdObject revolved(ObjectKind kind, std::span<const ProfilePoint> profile) {
  HouseholdObject object = standing(kind, make_revolution(profile, segments, max_edge));
  object.rotational.push_back({});
  return object;
}

Eigen::Vector3d box_size(Random& random) {
  switch (random.below(4)) {
    case 0:  // cereal
      return {random.uniform(0.14, 0.20), random.uniform(0.05, 0.07), random.uniform(0.20, 0.28)};
    case 1: {  // carton of milk: square
      const double side = random.uniform(0.065, 0.095);
      return {side, side, random.uniform(0.12, 0.20)};
    }
    case 2:  // tea, tissues
      return {random.uniform(0.10, 0.16), random.uniform(0.07, 0.11), random.uniform(0.06, 0.10)};
    default:  // a parcel or a book lying flat
      return {random.uniform(0.14, 0.22), random.uniform(0.10, 0.15), random.uniform(0.04, 0.07)};
  }
}

/// Every pair of nearly equal edges adds two diagonal planes, which are weak symmetries: the mean
/// distance of the reflected points from the surface is at most 0.02 of the diagonal of the box,
/// the bound of weak planes of scanned meshes.
void add_box_symmetries(HouseholdObject& object, const Eigen::Vector3d& size) {
  constexpr double most_off = 0.02;
  const double area = size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
  const Eigen::Vector3d center(0, 0, 0.5 * size.z());
  for (int axis = 0; axis < 3; ++axis) {
    object.reflectional.push_back(plane(center, Eigen::Vector3d::Unit(axis), true));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    const double moved = (size[a] + size[b]) * size[axis] / area;  // share of the faces that move
    if (0.5 * std::abs(size[a] - size[b]) * moved > most_off * size.norm()) continue;
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector3d normal = Eigen::Vector3d::Unit(a) + sign * Eigen::Vector3d::Unit(b);
      object.reflectional.push_back(plane(center, normal, false));
    }
  }
}

HouseholdObject make_box_object(Random& random, double scale) {
  const Eigen::Vector3d size = scale * box_size(random);
  HouseholdObject object = standing(ObjectKind::box, make_box(size, max_edge));
  object.top_radius = 0.5 * std::min(size.x(), size.y());
  add_box_symmetries(object, size);
  return object;
}

struct CanSize {
  double radius, height;
};
CanSize can_size(Random& random, double scale) {
  const bool tall = random.chance(0.25);
  const double radius = tall ? random.uniform(0.033, 0.042) : random.uniform(0.031, 0.052);
  return {scale * radius, scale * (tall ? random.uniform(0.18, 0.25) : random.uniform(0.07, 0.14))};
}

HouseholdObject make_can(Random& random, double scale) {
  const auto [r, h] = can_size(random, scale);
  constexpr double bevel = 0.002;
  const std::array<ProfilePoint, 6> profile = {
      {{0, 0}, {r - bevel, 0}, {r, bevel}, {r, h - bevel}, {r - bevel, h}, {0, h}}};
  HouseholdObject object = revolved(ObjectKind::can, profile);
  object.top_radius = r - bevel;
  object.reflectional.push_back(plane({0, 0, 0.5 * h}, Eigen::Vector3d::UnitZ(), false));
  return object;
}

HouseholdObject make_lying_can(Random& random, double scale) {
  const HouseholdObject can = make_can(random, scale);
  Eigen::Isometry3d lay = Eigen::Isometry3d::Identity();
  lay.rotate(Eigen::AngleAxisd(radians(90), Eigen::Vector3d::UnitY()));
  lay.pretranslate(Eigen::Vector3d(-0.5 * can.height, 0, can.footprint.back().norm()));
  HouseholdObject object = standing(ObjectKind::lying_can, transformed(can.mesh, lay));
  const double r = 0.5 * object.height;
  object.rotational.push_back({{{0, 0, r}, Eigen::Vector3d::UnitX()}, true});
  object.reflectional.push_back(plane({0, 0, r}, Eigen::Vector3d::UnitX(), false));
  return object;
}

HouseholdObject make_bowl(Random& random, double scale) {
  const double rim = scale * random.uniform(0.07, 0.14);
  const double h = scale * random.uniform(0.05, 0.10);
  const double wall = random.uniform(0.003, 0.0045);
  const double foot = random.uniform(0.45, 0.6) * rim;
  // A quarter of a superellipse from the foot to the rim, then back down inside it.
  std::vector<ProfilePoint> profile = {{0, 0}, {foot, 0}};
  std::vector<ProfilePoint> inner;
  constexpr int steps = 8;
  for (int k = 0; k <= steps; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / steps;
    const double across = foot + (rim - foot) * std::sin(angle);
    const double up = h * (1.0 - std::cos(angle));
    if (k > 0) profile.push_back({across, up});
    inner.push_back({across - wall, wall + (h - wall) * (1.0 - std::cos(angle))});
  }
  profile.insert(profile.end(), inner.rbegin(), inner.rend());
  profile.push_back({0, wall});
  HouseholdObject object = revolved(ObjectKind::bowl, profile);
  object.cavity = Cavity{foot - wall, wall};
  return object;
}

HouseholdObject make_bottle(Random& random, double scale) {
  const double r = scale * random.uniform(0.028, 0.045);
  const double h = scale * random.uniform(0.17, 0.28);
  const double neck = random.uniform(0.35, 0.5) * r;
  const double shoulder = random.uniform(0.5, 0.65) * h;
  const double slope = random.uniform(0.12, 0.22) * h;
  const double cap = neck + 0.003;
  std::vector<ProfilePoint> profile = {{0, 0}, {r - 0.003, 0}, {r, 0.003}};
  constexpr int steps = 8;
  for (int k = 0; k <= steps; ++k) {
    const double blend = 0.5 * (1.0 + std::cos(std::numbers::pi * k / steps));
    profile.push_back({neck + (r - neck) * blend, shoulder + slope * k / steps});
  }
  const double below_cap = h - 0.022;
  for (const ProfilePoint& p : std::initializer_list<ProfilePoint>{
           {neck, below_cap}, {cap, below_cap}, {cap, h - 0.001}, {cap - 0.001, h}, {0, h}}) {
    profile.push_back(p);
  }
  return revolved(ObjectKind::bottle, profile);
}

HouseholdObject make_cup(Random& random, double scale) {
  const double rim = scale * random.uniform(0.034, 0.05);
  const double foot = random.uniform(0.65, 1.0) * rim;
  const double h = scale * random.uniform(0.08, 0.14);
  const double wall = random.uniform(0.0025, 0.004);
  const double floor = random.uniform(0.004, 0.008);
  const double inner_foot = foot + (rim - foot) * floor / h - wall;
  const std::array<ProfilePoint, 6> profile = {
      {{0, 0}, {foot, 0}, {rim, h}, {rim - wall, h}, {inner_foot, floor}, {0, floor}}};
  return revolved(ObjectKind::cup, profile);
}

/// A sitting bear: body, head, ears, arms and legs; y = 0 is its mirror plane.
HouseholdObject make_toy(Random& random, double scale) {
  const double s = scale * random.uniform(0.8, 1.25);
  const auto vary = [&](double x, double y, double z) {
    const double f = random.uniform(0.88, 1.12);
    return Eigen::Vector3d(s * f * x, s * f * y, s * f * z);
  };
  const std::array<Ellipsoid, 7> parts = {{
      {s * Eigen::Vector3d(0, 0, 0.065), vary(0.055, 0.060, 0.070)},
      {s * Eigen::Vector3d(0.015, 0, 0.160), vary(0.050, 0.052, 0.046)},
      {s * Eigen::Vector3d(0.062, 0, 0.150), vary(0.026, 0.026, 0.022)},
      {s * Eigen::Vector3d(0.005, 0.045, 0.205), vary(0.016, 0.022, 0.022)},
      {s * Eigen::Vector3d(0.045, 0.062, 0.095), vary(0.045, 0.022, 0.024)},
      {s * Eigen::Vector3d(0.070, 0.050, 0.022), vary(0.060, 0.028, 0.027)},
      {s * Eigen::Vector3d(0.125, 0.055, 0.032), vary(0.018, 0.026, 0.032)},
  }};
  HouseholdObject object = standing(ObjectKind::toy, make_mirrored_body(parts, 0.008 * s, 0.005));
  object.reflectional.push_back(plane(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY(), true));
  return object;
}

HouseholdObject make_shape(ObjectKind kind, Random& random, double scale) {
  switch (kind) {
    case ObjectKind::box:
      return make_box_object(random, scale);
    case ObjectKind::can:
      return make_can(random, scale);
    case ObjectKind::lying_can:
      return make_lying_can(random, scale);
    case ObjectKind::bowl:
      return make_bowl(random, scale);
    case ObjectKind::bottle:
      return make_bottle(random, scale);
    case ObjectKind::cup:
      return make_cup(random, scale);
    case ObjectKind::toy:
      return make_toy(random, scale);
  }
  return {};
}

}  // namespace

const char* to_string(ObjectKind kind) {
  constexpr std::array<const char*, object_kind_count> names = {
      "box", "can", "lying_can", "bowl", "bottle", "cup", "toy"};
  return names[static_cast<std::size_t>(kind)];
}

ObjectKind random_object_kind(Random& random) {
  constexpr std::array<std::pair<ObjectKind, double>, object_kind_count> shares = {{
      {ObjectKind::box, 0.32},
      {ObjectKind::can, 0.18},
      {ObjectKind::lying_can, 0.05},
      {ObjectKind::bowl, 0.12},
      {ObjectKind::bottle, 0.11},
      {ObjectKind::cup, 0.12},
      {ObjectKind::toy, 0.10},
  }};
  double left = random.uniform();
  for (const auto& [kind, share] : shares) {
    if (left < share) return kind;
    left -= share;
  }
  return ObjectKind::box;
}

HouseholdObject make_household_object(ObjectKind kind, Random& random, double scale) {
  HouseholdObject object = make_shape(kind, random, scale);
  object.mesh.colors = paint(object.mesh.vertices, random);
  return object;
}

}  // namespace symscene
