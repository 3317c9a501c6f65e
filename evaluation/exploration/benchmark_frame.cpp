#include "benchmark_frame.hpp"

#include "symscene/clutter/clutter_world.hpp"

namespace symscene {

Tabletop in_benchmark_frame(Tabletop tabletop) {
  const Eigen::Isometry3d T_world_tabletop(
      Eigen::Translation3d(0.5 * clutter::size, 0.5 * clutter::size, clutter::table_height));
  tabletop.T_world_table = T_world_tabletop * tabletop.T_world_table;
  for (PlacedObject& placed : tabletop.objects)
    placed.T_world_object = T_world_tabletop * placed.T_world_object;
  return tabletop;
}

}  // namespace symscene
