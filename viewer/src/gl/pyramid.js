// A camera as a viewing pyramid: its edges as pairs of points, and its image plane.
import { closed } from './lines.js';
import { add, scale } from '../vector.js';

/** A pyramid of this depth [m]; `halfWidth` and `halfHeight` are of the image at unit depth. */
export function pyramid({ position, right, down, forward }, [halfWidth, halfHeight], depth) {
  const at = (x, y) => add(add(position, scale(forward, depth)),
    add(scale(right, x * halfWidth * depth), scale(down, y * halfHeight * depth)));
  const frame = [at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)];
  return { frame, edges: [...closed(frame), ...frame.map((corner) => [position, corner])] };
}
