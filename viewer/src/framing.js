// What a view must show: the objects, and what stands around them unless it is far away.
import { outlinePoints } from './gl/symmetries.js';

const AROUND = 1.5; // times the objects' radius
const NOTHING = [[-0.3, 0, -0.3], [0.3, 0.2, 0.3]]; // a view of the bare table

function middleOf(points) {
  return [0, 1, 2].map((axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length);
}

export function framePoints(scene, outlines) {
  const indices = Uint32Array.from({ length: scene.cloud.count }, (_, i) => i);
  const cloud = outlinePoints(scene.cloud, { points: indices, completed: { positions: [], count: 0 } }, 4000);
  const objects = outlines.flat();
  if (objects.length === 0) return cloud.length ? cloud : NOTHING;
  const middle = middleOf(objects);
  const distance = (p) => Math.hypot(...p.map((value, axis) => value - middle[axis]));
  const radius = objects.reduce((most, p) => Math.max(most, distance(p)), 0);
  return objects.concat(cloud.filter((p) => distance(p) < AROUND * radius));
}
