// The display frame: x to the right, y up off the table, z towards whoever looks; metres, its
// origin on the table under the middle of the scene.
import { shownPositions } from './shown.js';
import { add, cross, dot, isVector, length, normalize, quantile, reject, scale, subtract } from './vector.js';

// Normals of visible surfaces face the sensor, so that their mean points towards it. Without any,
// the first camera tells.
function sensorSide({ cloud, trajectory }, center, up) {
  const sum = [0, 0, 0];
  for (let i = 0; i < cloud.normals.length; ++i) sum[i % 3] += cloud.normals[i];
  const camera = cloud.count === 0 && trajectory?.cameras[0];
  const side = camera ? subtract(camera.position, center) : scale(sum, 1 / Math.max(1, cloud.count));
  const lean = reject(side, up);
  if (length(lean) > 0.05) return normalize(lean);
  const fallback = Math.abs(up[1]) < 0.9 ? [0, -1, 0] : [0, 0, 1];
  return normalize(reject(fallback, up));
}

function heights(positions, up) {
  const values = new Float32Array(positions.length / 3);
  for (let i = 0; i < values.length; ++i) {
    values[i] = dot(positions.subarray(3 * i, 3 * i + 3), up);
  }
  return values;
}

function middle(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  return positions.length ? scale(add(low, high), 0.5) : [0, 0, 0];
}

export function tableFrame(scene) {
  const { table } = scene;
  const shown = shownPositions(scene);
  const up = normalize(isVector(scene.up) ? scene.up : [0, 0, 1]);
  const center = middle(shown);
  const front = sensorSide(scene, center, up);
  const right = cross(up, front);
  const height = Number.isFinite(table) ? table : quantile(heights(shown, up), 0.002) - 0.002;
  const origin = add(center, scale(up, height - dot(center, up)));
  const direction = (v) => [dot(v, right), dot(v, up), dot(v, front)];
  const turned = ([x, y, z]) => add(add(scale(right, x), scale(up, y)), scale(front, z));
  return {
    direction,
    point: (p) => direction(subtract(p, origin)),
    toWorld: (p) => add(origin, turned(p)),
    /** Of point(), column by column. */
    matrix: [...[0, 1, 2].flatMap((axis) => [right[axis], up[axis], front[axis], 0]), ...scale(direction(origin), -1), 1],
  };
}

function mapTriples(array, map) {
  for (let i = 0; i < array.length; i += 3) array.set(map([array[i], array[i + 1], array[i + 2]]), i);
}

function moveCloud(cloud, frame) {
  mapTriples(cloud.positions, frame.point);
  mapTriples(cloud.normals, frame.direction);
}

function moveObject(object, frame) {
  moveCloud(object.completed, frame);
  if (object.closed) mapTriples(object.closed.positions, frame.point);
  object.shape = object.class && {
    ...object.class,
    center: frame.point(object.class.center),
    axes: object.class.axes.map(frame.direction),
  };
  object.axes = object.rotational.map((s) => ({
    point: frame.point(s.point),
    direction: frame.direction(s.direction),
    residual: s.residual,
  }));
  object.planes = object.reflectional.map((s) => ({
    point: frame.point(s.point),
    normal: frame.direction(s.normal),
    residual: s.residual,
  }));
}

function moveCamera({ position, right, down, forward }, frame) {
  return {
    position: frame.point(position),
    right: frame.direction(right),
    down: frame.direction(down),
    forward: frame.direction(forward),
  };
}

function moveTrajectory(trajectory, frame) {
  mapTriples(trajectory.path, frame.point);
  trajectory.cameras = trajectory.cameras.map((camera) => moveCamera(camera, frame));
}

const moveGrasp = (grasp, frame) => ({
  ...grasp,
  position: frame.point(grasp.position),
  closing: frame.direction(grasp.closing),
  approach: frame.direction(grasp.approach),
});

function moveGrasps(grasps, frame) {
  for (const list of ['accepted', 'rejected']) grasps[list] = grasps[list].map((grasp) => moveGrasp(grasp, frame));
}

function moveViews(views, frame) {
  views.list = views.list.map((view) => ({ ...view, camera: moveCamera(view.camera, frame) }));
}

const moveSweep = (sweep, frame) => sweep.map(({ camera, depth }) => ({ camera: moveCamera(camera, frame), depth }));

/** Moves every point, camera, view, grasp and symmetry of the scene into the display frame, in place, and keeps the frame. */
export function moveToTableFrame(scene) {
  const frame = tableFrame(scene);
  moveCloud(scene.cloud, frame);
  for (const object of scene.objects) moveObject(object, frame);
  if (scene.surface) mapTriples(scene.surface.positions, frame.point);
  if (scene.trajectory) moveTrajectory(scene.trajectory, frame);
  if (scene.grasps) moveGrasps(scene.grasps, frame);
  if (scene.views) moveViews(scene.views, frame);
  if (scene.sweep) scene.sweep = moveSweep(scene.sweep, frame);
  scene.frame = frame;
  return scene;
}
