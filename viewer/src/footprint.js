// The size of an object on the table: length and width of its footprint, and height.
import { quantile } from './vector.js';

const spread = (values) => quantile(values, 0.99) - quantile(values, 0.01);

/** Length, width and height of points with y up; the footprint's box has the least area of many. */
export function footprint(points) {
  let best = [0, 0];
  let least = Infinity;
  for (let angle = 0; angle < 90; angle += 5) {
    const [c, s] = [Math.cos((angle * Math.PI) / 180), Math.sin((angle * Math.PI) / 180)];
    const sides = [spread(points.map(([x, , z]) => c * x + s * z)), spread(points.map(([x, , z]) => c * z - s * x))];
    if (sides[0] * sides[1] < least) {
      least = sides[0] * sides[1];
      best = sides.sort((a, b) => b - a);
    }
  }
  return [...best, spread(points.map((p) => p[1]))];
}
