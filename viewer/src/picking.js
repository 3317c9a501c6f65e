// The object under the pointer: that of the frontmost point near it.
import { HIDDEN } from './ownership.js';

/**
 * The owner and position of the point at (x, y) in normalised device coordinates, or null. `layers` are the drawn {positions,
 * owners}, `m` is the view-projection matrix, `reach` the largest distance along x and y. Runs over
 * up to half a million points at every pointer move, hence without allocations.
 */
export function pick(layers, m, [x, y], [reachX, reachY]) {
  let best = -1;
  let from = null;
  let bestDepth = Infinity;
  for (const layer of layers) {
    const { positions, owners } = layer;
    for (let i = 0, k = 0; i < owners.length; ++i, k += 3) {
      const [px, py, pz] = [positions[k], positions[k + 1], positions[k + 2]];
      const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
      if (w <= 0 || w >= bestDepth || owners[i] === HIDDEN) continue;
      if (Math.abs(m[0] * px + m[4] * py + m[8] * pz + m[12] - x * w) > reachX * w) continue;
      if (Math.abs(m[1] * px + m[5] * py + m[9] * pz + m[13] - y * w) > reachY * w) continue;
      best = i;
      from = layer;
      bestDepth = w;
    }
  }
  if (!from) return null;
  return { owner: from.owners[best], position: [...from.positions.subarray(3 * best, 3 * best + 3)] };
}
