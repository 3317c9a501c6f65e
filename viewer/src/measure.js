// Measuring: two clicked points and the distance between them.
import { add, length, scale, subtract } from './vector.js';

/** The marks after a click: a third one begins anew. */
export const withMark = (marks, position) => (marks.length === 2 ? [position] : [...marks, position]);

/** The distance between two marks [m], or null. */
export const distanceOf = (marks) => (marks.length === 2 ? length(subtract(marks[1], marks[0])) : null);

export const middleOf = ([a, b]) => scale(add(a, b), 0.5);

/** "12.3 cm (across 10.1, up 7.0)": y of the display frame is up. */
export function measureText(marks) {
  const [x, y, z] = subtract(marks[1], marks[0]);
  const cm = (value) => (100 * value).toFixed(1);
  return `${cm(distanceOf(marks))} cm (across ${cm(Math.hypot(x, z))}, up ${cm(Math.abs(y))})`;
}
