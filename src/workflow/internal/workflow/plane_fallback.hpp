#pragma once

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "symscene/tabletop/scene_building.hpp"

namespace symscene {

/// What build(known) makes: a BuiltScene, or a struct with one as `built`. If no point is on the
/// given plane, all that is seen is taken, and a warning of the scene says so.
template <class Build>
auto even_if_plane_misses(TablePrior known, const Build& build) {
  const auto scene_in = [](auto& made) -> Scene& {
    if constexpr (requires { made.built; })
      return made.built.scene;
    else
      return made.scene;
  };
  try {
    return build(known);
  } catch (const InputError& error) {
    if (!known.plane) throw;
    known.plane.reset();
    known.absent = true;
    auto made = build(known);
    scene_in(made).warnings.push_back(fmt::format("{}; all that is seen is taken", error.what()));
    return made;
  }
}

}  // namespace symscene
