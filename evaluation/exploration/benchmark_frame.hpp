#pragma once

#include "symscene/simulation/tabletop.hpp"

namespace symscene {

/// The tabletop moved so that the middle of its table is that of the clutter benchmark, in the
/// world frame of the benchmark. The table must be z = 0 of the frame in which it is given.
Tabletop in_benchmark_frame(Tabletop tabletop);

}  // namespace symscene
