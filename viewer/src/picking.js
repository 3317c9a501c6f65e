// Which object lies under the pointer: the nearest disc to the viewer that covers it.
import { HIDDEN } from './ownership.js';

/** The owner under (x, y), or null. `layers` are {positions, owners} that are drawn. */
export function pick(layers, project, x, y, radius) {
  let best = null;
  let bestDepth = Infinity;
  for (const { positions, owners } of layers) {
    for (let i = 0; i < owners.length; ++i) {
      if (owners[i] === HIDDEN) continue;
      const p = project(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
      if (!p || p.depth >= bestDepth) continue;
      if (Math.abs(p.x - x) > radius || Math.abs(p.y - y) > radius) continue;
      best = owners[i];
      bestDepth = p.depth;
    }
  }
  return best;
}
