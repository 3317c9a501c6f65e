#pragma once

#include "brick_key.hpp"
#include "occupancy_hits.hpp"
#include "occupancy_view.hpp"

namespace symscene {

/// The free and occupied space that one frame shows.
struct FrameEvidence {
  const OccupancyView& view;
  const OccupancyHits& hits;
  const LogOddsModel& model;
};

/// Adds the evidence of a frame to a brick. Bricks may be updated in parallel.
void update_brick(OccupancyBrick& brick, BrickKey key, const FrameEvidence& evidence);

}  // namespace symscene
