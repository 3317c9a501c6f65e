#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/simulation/object_model.hpp"

namespace symscene {

/// The table and the room around it.
struct TableOptions {
  double length = 2.4;
  double width = 2.4;
  double height = 0.0;
  double wall_distance = 0.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("length", self.length, "m", above(0.0),
          "extent of the table along the view of the camera in the middle of its arc");
    visit("width", self.width, "m", above(0.0), "extent of the table across that view");
    visit("height", self.height, "m", between(0.0, 3.0), "height above a floor; 0 for no floor");
    visit("wall_distance", self.wall_distance, "m", at_least(0.0),
          "distance of a wall behind the middle of the table; 0 for no wall");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// How objects are arranged on the table.
struct TabletopOptions {
  static constexpr double contact_gap = 0.0005;  ///< between objects that touch [m]

  int objects = 6;
  double stacked = 0.25;
  double touching = 0.3;
  double min_gap = 0.003;
  double max_gap = 0.04;
  double max_stack = 0.35;
  bool random_frame = false;
  std::uint64_t seed = 1;
  TableOptions table = {};

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("objects", self.objects, "", between(1, 20), "objects on the table");
    visit("stacked", self.stacked, "", between(0.0, 1.0),
          "share of the objects that are tried on top of or inside another");
    visit("touching", self.touching, "", between(0.0, 1.0),
          "share of the objects that are pushed up against another");
    visit("min_gap", self.min_gap, "m", at_least(contact_gap),
          "least gap between objects that do not touch");
    visit("max_gap", self.max_gap, "m", at_least(contact_gap),
          "largest gap between objects that do not touch");
    visit("max_stack", self.max_stack, "m", above(0.0), "greatest height of a stack of objects");
    visit("random_frame", self.random_frame, "", any_value(),
          "rotate and shift the world at random, as in a real scan");
    visit("seed", self.seed, "", any_value(), "seed of the objects and their places");
    visit("table", self.table);
  }
  /// Throws InputError if a value is out of its range or max_gap is below min_gap.
  void validate() const;
};

/// An object at its place.
struct PlacedObject {
  static constexpr Index on_table = ~Index{0};

  ObjectModel object;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();
  Index supporter = on_table;  ///< number of the object that it stands on or in
};

/// A table with objects on it that are known exactly.
struct Tabletop {
  Eigen::Isometry3d T_world_table = Eigen::Isometry3d::Identity();  ///< z = 0 is the table, z up
  TableOptions table;
  std::vector<PlacedObject> objects;
  std::vector<std::string> warnings;  ///< models that were not used or found no place

  /// The plane of the table with its normal up. World frame.
  Plane plane() const;
};

/// Arranges random household objects on a table, side by side and on top of each other, so that
/// each rests on a support and none intersects another. Throws InputError if an option is out of
/// range.
Tabletop arrange_tabletop(const TabletopOptions& options);

/// The mesh of a placed object. World frame.
TriangleMesh world_mesh(const PlacedObject& placed);

}  // namespace symscene
