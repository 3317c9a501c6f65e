// The frame of the view: y up, and turned so that the robot's base is behind the objects. Objects, bin and hand are framed
// where they are at some moments of the run, and the robot unless far away: a large one would make the objects small.
import * as THREE from 'three';
import { placed } from './recording.js';
import { poseAt } from './track.js';

const MOMENTS = 12;
const AROUND = 1.5; // times the radius of objects, bin and hand
const BASE_AT = (115 * Math.PI) / 180; // direction of the base from the objects, 90° is away from the viewer
const NOTHING = [[-0.3, 0, -0.3], [0.3, 0.3, 0.3]];

function middleAt({ track, extent }, time) {
  return placed(poseAt(track, time), extent.middle);
}

const mean = (points) => [0, 1, 2].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);

function turnOf({ solids, objects, begin }) {
  const base = solids.find(({ kind, extent }) => kind === 'robot' && extent);
  const seen = objects.filter(({ extent }) => extent);
  if (!base || seen.length === 0) return 0;
  const [from, to] = [mean(seen.map((object) => middleAt(object, begin))), middleAt(base, begin)];
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  return Math.hypot(dx, dy) > 1e-3 ? BASE_AT - Math.atan2(dy, dx) : 0;
}

function cornersOf({ low, high }) {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]]);
}

function pointsOf(solids, times) {
  return solids.flatMap(({ track, extent }) => times.flatMap((time) => {
    const pose = poseAt(track, time);
    return cornersOf(extent).map((corner) => placed(pose, corner));
  }));
}

// The table is larger than what matters on it, and objects may fall far: they count where they are first.
export function framedPoints({ solids, begin, end }) {
  const moments = Array.from({ length: MOMENTS }, (_, i) => begin + ((end - begin) * i) / (MOMENTS - 1));
  const of = (...kinds) => solids.filter(({ kind, extent }) => extent && kinds.includes(kind));
  const core = pointsOf(of('object'), [begin]).concat(pointsOf(of('hand', 'bin'), moments));
  const robot = pointsOf(of('robot'), moments);
  if (core.length === 0) return robot;
  const middle = mean(core);
  const distance = (p) => Math.hypot(...p.map((value, k) => value - middle[k]));
  const radius = core.reduce((most, p) => Math.max(most, distance(p)), 0);
  return core.concat(robot.filter((p) => distance(p) < AROUND * radius));
}

function reachOf({ solids, begin }, matrix) {
  const points = solids.filter(({ extent }) => extent).flatMap((solid) =>
    cornersOf(solid.extent).map((corner) => placed(poseAt(solid.track, begin), corner)));
  return points.reduce((most, p) => Math.max(most, new THREE.Vector3(...p).applyMatrix4(matrix).length()), 0);
}

// The lowest point of what stands still, so that it seems to stand on something.
function floorOf({ solids, begin }) {
  const standing = solids.filter(({ kind, extent }) => extent && (kind === 'bin' || kind === 'robot'));
  return Math.min(-0.002, ...pointsOf(standing, [begin]).map(([, , z]) => z));
}

/** How the view stands to the table, which points it frames, and how far everything reaches from its origin. */
export function frameOf(recording) {
  const turn = new THREE.Matrix4().makeRotationZ(turnOf(recording));
  const matrix = new THREE.Matrix4().makeRotationX(-Math.PI / 2).multiply(turn);
  const point = (p) => new THREE.Vector3(...p).applyMatrix4(matrix).toArray();
  const framed = framedPoints(recording).map(point);
  const points = framed.length > 0 ? framed : NOTHING;
  const box = new THREE.Box3().setFromPoints(points.map((p) => new THREE.Vector3(...p)));
  const center = box.getCenter(new THREE.Vector3());
  const radius = 0.5 * box.getSize(new THREE.Vector3()).length();
  return { matrix, point, points, center, radius, floor: floorOf(recording), reach: 1.1 * reachOf(recording, matrix) };
}
