#pragma once

#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/simulation/object_model.hpp"

namespace symscene {

/// How objects are put on the table.
struct TabletopOptions {
  int objects = 6;            ///< how many, 1 to 15
  double stacked = 0.25;      ///< share of the objects that try to stand on or in another
  double touching = 0.3;      ///< share of the objects that are pushed up against another
  double min_gap = 0.003;     ///< between objects that do not touch [m]
  double max_gap = 0.04;      ///< between objects that do not touch [m]
  bool random_frame = false;  ///< turn and shift the world at random, as in a real scan
  std::uint64_t seed = 1;     ///< of everything random about the objects and their places

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("objects", self.objects, "", "objects on the table, 1 to 15");
    visit("stacked", self.stacked, "", "share of the objects that try to stand on or in another");
    visit("touching", self.touching, "", "share of the objects pushed up against another");
    visit("min_gap", self.min_gap, "m", "least gap between objects that do not touch");
    visit("max_gap", self.max_gap, "m", "largest gap between objects that do not touch");
    visit("random_frame", self.random_frame, "", "turn and shift the world at random");
    visit("seed", self.seed, "", "seed of the objects and their places");
  }
  void validate() const;
};

/// An object in its place.
struct PlacedObject {
  static constexpr Index on_table = ~Index{0};

  ObjectModel object;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();
  Index supporter = on_table;  ///< the object that it stands on or in
};

/// A table with objects on it, every one of which is known exactly.
struct Tabletop {
  Eigen::Isometry3d T_world_table = Eigen::Isometry3d::Identity();  ///< z = 0 is the table, z up
  std::vector<PlacedObject> objects;

  Plane plane() const;
};

/// Puts random household objects on a table, side by side and on top of each other, so that they
/// rest on what is below them and nowhere run into each other.
Tabletop arrange_tabletop(const TabletopOptions& options);

/// A table whose origin is the world's, or is turned and shifted at random if `options` ask for it.
Tabletop empty_tabletop(const TabletopOptions& options);

/// The mesh of a placed object. World frame.
TriangleMesh world_mesh(const PlacedObject& placed);

/// What is true of a placed object, all but its points. World frame.
TrueObject true_object(const PlacedObject& placed);

}  // namespace symscene
