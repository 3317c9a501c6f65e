#include "symscene/workflow/known_table.hpp"

namespace symscene {

TablePrior KnownTable::with(TablePrior from_cameras) const {
  from_cameras.plane = plane;
  from_cameras.absent = absent;
  from_cameras.any_up = any_up;
  if (any_up) from_cameras.up.reset();
  return from_cameras;
}

}  // namespace symscene
