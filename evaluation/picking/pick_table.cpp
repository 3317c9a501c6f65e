#include "symscene/picking/pick_table.hpp"

#include <map>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {

TabletopOptions PickTableOptions::default_tabletop() {
  TabletopOptions tabletop;
  tabletop.table = {0.8, 0.8, 0.75, 0.0};
  return tabletop;
}

DropOptions PickTableOptions::default_drop() {
  DropOptions drop;
  drop.spread = 0.15;
  drop.area = 0.3;
  return drop;
}

void PickTableOptions::validate() const {
  tabletop.validate();
  drop.validate();
  require_option(!tabletop.random_frame, "random_frame", "false: the robot stands at the table",
                 1.0);
}

namespace {

/// Objects of one name are numbered: "cup", "cup 2".
void make_names_unique(std::vector<PlacedObject>& objects) {
  std::map<std::string, int> seen;
  for (PlacedObject& placed : objects) {
    const int number = ++seen[placed.object.name];
    if (number > 1) placed.object.name += fmt::format(" {}", number);
  }
}

}  // namespace

PickTable furnish_pick_table(std::span<const ObjectModel> models, const PickTableOptions& options) {
  options.validate();
  PickTable table{{}, options.drop.physics.density, options.drop.parts};
  table.tabletop = models.empty() ? arrange_tabletop(options.tabletop)
                                  : drop_tabletop(models, options.tabletop, options.drop);
  make_names_unique(table.tabletop.objects);
  return table;
}

}  // namespace symscene
