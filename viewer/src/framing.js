// Points that a view frames: the objects, their surroundings unless far away, and the camera's path
// if it is drawn.
import { outlinePoints } from './gl/symmetries.js';
import { graspsOfObject } from './grasps.js';
import { shownPositions } from './shown.js';
import { add, scale, subtract } from './vector.js';

const AROUND = 1.5; // times the objects' radius
const NOTHING = [[-0.3, 0, -0.3], [0.3, 0.2, 0.3]]; // a view of the bare table

function middleOf(points) {
  return [0, 1, 2].map((axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length);
}

export function framePoints(scene, outlines) {
  const positions = shownPositions(scene);
  const indices = Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  const cloud = outlinePoints({ positions }, { points: indices, completed: { positions: [], count: 0 } }, 4000);
  const objects = outlines.flat();
  if (objects.length === 0) return cloud.length ? cloud : NOTHING;
  const middle = middleOf(objects);
  const distance = (p) => Math.hypot(...p.map((value, axis) => value - middle[axis]));
  const radius = objects.reduce((most, p) => Math.max(most, distance(p)), 0);
  return objects.concat(cloud.filter((p) => distance(p) < AROUND * radius));
}

/** The far ends of the palms of the grippers that are drawn first. */
export function gripperPoints({ grasps, objects }) {
  if (!grasps) return [];
  const [, length, height] = grasps.gripper.palm_size;
  const best = objects.map(({ index }) => graspsOfObject(grasps, index, 'a')[0]).filter(Boolean);
  return best.flatMap(({ grasp: { position, closing, approach } }) => {
    const end = subtract(position, scale(approach, height));
    return [-0.5, 0.5].map((side) => add(end, scale(closing, side * length)));
  });
}

/** Where the best view would be taken from. */
export const viewPoints = ({ views }) => (views?.list ?? []).slice(0, 1).map(({ camera }) => camera.position);

/** Positions of cameras, thinned because each framing visits all of them. */
export function pathPoints({ trajectory }) {
  if (!trajectory) return [];
  const { path, cameras } = trajectory;
  const step = 3 * Math.ceil(path.length / 300);
  const points = cameras.map(({ position }) => position);
  for (let i = 0; i < path.length; i += step) points.push([...path.subarray(i, i + 3)]);
  return points;
}

/** Largest distance from the origin of anything drawn, framed or not. */
export function reach({ surface, trajectory, views, sweep }) {
  let most = 0;
  for (const { camera } of views?.list ?? []) most = Math.max(most, Math.hypot(...camera.position));
  for (const { camera } of sweep ?? []) most = Math.max(most, Math.hypot(...camera.position));
  for (const positions of [surface?.positions ?? [], trajectory?.path ?? []]) {
    for (let i = 0; i < positions.length; i += 3) {
      most = Math.max(most, Math.hypot(positions[i], positions[i + 1], positions[i + 2]));
    }
  }
  return 1.1 * most;
}
