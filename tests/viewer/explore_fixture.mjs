// An exploration of two boxes with three views. Frame of the table: z up.
import { encodeRun } from './payload.mjs';
import { add, box, moved } from './run_meshes.mjs';

const HALF_SIZE = [0.59, 0.44];
const STEP = 2; // between two views [s]
const RADIUS = 0.6;
const BOXES = [{ name: 'sugar', at: [0.08, 0, 0], size: [0.05, 0.09, 0.17] }, { name: 'brick', at: [-0.07, 0.05, 0], size: [0.06, 0.2, 0.07] }];

const scaled = (v, factor) => v.map((value) => value * factor);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const unit = (v) => scaled(v, 1 / Math.hypot(...v));

/** A camera on the half sphere that looks at its middle, with its axes. */
function cameraAt(azimuth, fromVertical = 0.9) {
  const outward = [Math.sin(fromVertical) * Math.cos(azimuth), Math.sin(fromVertical) * Math.sin(azimuth), Math.cos(fromVertical)];
  const forward = scaled(outward, -1);
  const right = unit(cross(forward, [0, 0, 1]));
  return { position: scaled(outward, RADIUS), right, down: cross(forward, right), forward };
}

const candidate = (number, gain) => ({
  candidate: number, camera: cameraAt(number), gain, inferred: 0.6 * gain, disputed: 0, unknown: 0.4 * gain, cost: 0,
});

function ranking(gains, isEnough = false) {
  const list = Object.entries(gains).map(([number, gain]) => candidate(Number(number), gain)).sort((a, b) => b.gain - a.gain);
  return { policy: 'symmetry', unit: 'cm²', half_size: HALF_SIZE, is_enough: isEnough, list };
}

/** A ramp with a hole in its first pixel. */
function depth() {
  const nearness = Uint8Array.from({ length: 16 * 12 }, (_, i) => (i === 0 ? 0 : 1 + (i % 255)));
  return { width: 16, height: 12, data: Buffer.from(nearness).toString('base64') };
}

const VIEWS = [
  { view: candidate(0, 0), observed: 0.41, completed: 0.62, objects: 1, next: ranking({ 1: 12, 2: 31.5, 4: 8 }) },
  { view: candidate(2, 31.5), observed: 0.78, completed: 0.9, objects: 2, next: ranking({ 1: 4, 4: 9.25 }) },
  { view: candidate(4, 9.25), observed: 0.93, completed: 0.97, objects: 2, next: ranking({ 1: 0.2 }, true) },
];

const still = (position) => ({ position, rotation: [0, 0, 0, 1] });
const surfaceOf = ({ at, size }) => moved(box(size), at);

/** `ranked`: whether the policy ranks views. */
export function exploredBoxes({ title = 'Next views by symmetry', ranked = true } = {}) {
  const cameras = VIEWS.map(({ view }) => view.camera.position);
  const solids = [...BOXES.map(({ name, size }) => ({ name, kind: 'object', mesh: box(size) })),
    { name: 'table', kind: 'table', mesh: moved(box([0.7, 0.7, 0.02]), [0, 0, -0.02]) }, { name: 'camera', kind: 'hand', mesh: box([0.04, 0.04, 0.04]) }];
  const posesAt = (camera) => [...BOXES.map(({ at }) => still(at)), still([0, 0, 0]), still(camera)];
  const run = encodeRun({
    title, solids, times: VIEWS.map((_, k) => k * STEP), poses: cameras.map((camera) => posesAt(add(camera, [0, 0, 0]))),
    beliefs: VIEWS.map(({ objects }, k) => ({ time: k * STEP, objects: BOXES.slice(0, objects)
      .map((each, i) => ({ name: `object ${i}`, label: `box ${i}, 0.9`, mesh: surfaceOf(each) })) })),
    events: VIEWS.map((_, k) => ({ time: k * STEP, text: `view ${k + 1}`, outcome: 'note' })),
    left: ['3 % of the surface of 2 known objects (12 cm²) is inferred, not seen'],
  });
  const views = VIEWS.map((view, k) => ({ ...view, time: k * STEP, depth: depth(), next: ranked ? view.next : { ...view.next, list: [] } }));
  return { ...run, exploration: { views, end: 'no further view is expected to show much more' } };
}
