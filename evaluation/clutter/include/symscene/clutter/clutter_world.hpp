#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/clutter/clutter_objects.hpp"
#include "symscene/clutter/grasp_execution.hpp"

namespace symscene {

enum class ClutterKind {
  packed,  ///< upright objects side by side
  pile     ///< objects in any orientation that were dropped into a tray
};

/// "packed" or "pile".
const char* to_string(ClutterKind kind);

/// The kind of that name. Throws InputError for any other text.
ClutterKind parse_clutter_kind(const std::string& text);

/// The world of the clutter-removal benchmark of VGN: a cube with its lower corner at the origin;
/// the table is the plane z = table_height.
namespace clutter {
constexpr double size = 0.3;           // edge of the cube [m]
constexpr double table_height = 0.05;  // [m]
}  // namespace clutter

/// An object in the world.
struct ClutterItem {
  std::size_t object = 0;  ///< into the objects from which items are drawn
  double scale = 1.0;
};

/// A table with objects that come to rest, and a hand that removes them. The same seed gives the
/// same world.
class ClutterWorld {
 public:
  /// Draws `count` objects, which must outlive the world, and settles them; a packed scene can hold
  /// fewer. Throws InputError if the objects cannot be simulated or this build has no physics, and
  /// PhysicsDiverged.
  ClutterWorld(std::span<const ClutterObject> objects, ClutterKind kind, int count,
               std::uint64_t seed, const GraspWorldOptions& options = {});

  /// All items that were drawn.
  const std::vector<ClutterItem>& items() const { return items_; }
  const ClutterObject& object(std::size_t item) const { return objects_[items_[item].object]; }
  /// The items that are on the table, ascending.
  std::vector<std::size_t> present() const;
  /// T_world_object, without the scale.
  Eigen::Isometry3d pose(std::size_t item) const;
  /// Its surface where it is now.
  TriangleMesh surface(std::size_t item) const;
  /// The surfaces of the items that are on the table, in the order of present().
  std::vector<TriangleMesh> surfaces() const;

  /// How far the open hand at a grasp reaches into the table or an item other than `aimed`. [m]
  double penetration(const Eigen::Isometry3d& T_world_tool, std::size_t aimed);

  /// Executes a grasp, takes a body that is held out of the world and waits until the rest has
  /// settled.
  GraspOutcome execute(const Eigen::Isometry3d& T_world_tool,
                       const GraspExecutionOptions& options = {});

  /// Executes a grasp and puts all bodies back to where they were, at rest.
  GraspOutcome rehearse(const Eigen::Isometry3d& T_world_tool,
                        const GraspExecutionOptions& options = {});

  /// Simulated time so far. [s]
  double time() const { return time_; }

 private:
  void drop_into_tray();
  void set_upright(int count);
  void advance(double seconds);
  void advance_to_rest(double seconds);
  bool take_away_outside();
  void settle();

  std::span<const ClutterObject> objects_;
  std::vector<ClutterItem> items_;
  std::vector<Eigen::Isometry3d> drawn_;  ///< T_table_object where an item is put
  std::vector<ConvexParts> parts_;        ///< scaled, per item
  double time_ = 0.0;
  std::optional<GraspWorld> world_;
};

}  // namespace symscene
