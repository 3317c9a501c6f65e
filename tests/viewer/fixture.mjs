// A synthetic tabletop: solids of revolution and boxes, observed from one side; completion adds the
// unseen sides. World frame: z up, the table at z = 0, the camera at −y.
import { closedSurface, scannedSurface, sweep } from './scan.mjs';
import { encodeScene } from './payload.mjs';

const CAMERA = [0.15, -1.15, 0.8];

// mulberry32
export function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A surface of revolution about the vertical: `profile` is a polyline of (radius, height). */
function revolve({ at: [x, y], profile, paint }, cell, random) {
  const samples = [];
  for (let k = 0; k + 1 < profile.length; ++k) {
    const [[r0, z0], [r1, z1]] = [profile[k], profile[k + 1]];
    const length = Math.hypot(r1 - r0, z1 - z0);
    const count = Math.round((length * Math.PI * (r0 + r1)) / (0.4 * cell) ** 2);
    for (let i = 0; i < count; ++i) {
      const t = random();
      const a = 2 * Math.PI * random();
      const [r, z] = [r0 + t * (r1 - r0), z0 + t * (z1 - z0)];
      const [nr, nz] = [(z1 - z0) / length, -(r1 - r0) / length];
      const p = [x + r * Math.cos(a), y + r * Math.sin(a), z];
      samples.push({ p, n: [nr * Math.cos(a), nr * Math.sin(a), nz], c: paint(a, z) });
    }
  }
  return samples;
}

function box({ at: [x, y], size, turn, paint }, cell, random) {
  const samples = [];
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const place = ([a, b, h]) => [c * a - s * b, s * a + c * b, h];
  for (let axis = 0; axis < 3; ++axis) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    for (const side of [-1, 1]) {
      const count = Math.round((size[u] * size[v]) / (0.4 * cell) ** 2);
      for (let i = 0; i < count; ++i) {
        const q = [0, 0, 0];
        const n = [0, 0, 0];
        q[axis] = (side * size[axis]) / 2;
        q[u] = (random() - 0.5) * size[u];
        q[v] = (random() - 0.5) * size[v];
        n[axis] = side;
        const p = place(q);
        samples.push({ p: [p[0] + x, p[1] + y, p[2] + size[2] / 2], n: place(n), c: paint(q, axis) });
      }
    }
  }
  return samples;
}

// One sample per cell, like the pipeline's sampling.
function thin(samples, cell) {
  const kept = new Map();
  for (const sample of samples) {
    const key = sample.p.map((value) => Math.round(value / cell)).join();
    if (!kept.has(key)) kept.set(key, sample);
  }
  return [...kept.values()];
}

const stripes = (a, b, every) => (_, z) => (Math.floor(z / every) % 2 ? a : b);
const arc = (radius, height, from, to) => Array.from({ length: 15 }, (_, i) => {
  const t = from + ((to - from) * i) / 14;
  return [radius * Math.cos(t), height + radius * Math.sin(t)];
});

const SOLIDS = [
  { kind: revolve, at: [0.02, 0.02], profile: [[0.037, 0], [0.037, 0.235], [0, 0.235]], paint: stripes([58, 160, 62], [214, 224, 90], 0.06) },
  { kind: revolve, at: [-0.2, -0.12], profile: [[0.06, 0], ...arc(0.105, 0.105, -1, 0), [0.1, 0.105], ...arc(0.098, 0.105, 0, -1.5)], paint: () => [178, 32, 36] },
  { kind: revolve, at: [0.22, -0.1], profile: [[0.042, 0], [0.058, 0.1], [0.06, 0.102], [0, 0.105]], paint: stripes([206, 40, 40], [240, 214, 160], 0.035) },
  { kind: revolve, at: [0.06, -0.19], profile: arc(0.038, 0.038, -1.57, 1.57), paint: () => [240, 150, 40] },
  { kind: box, at: [-0.08, 0.17], size: [0.2, 0.15, 0.24], turn: 0.45, paint: (q, axis) => (axis !== 2 && Math.abs(q[2]) < 0.04 ? [110, 66, 40] : [186, 134, 84]) },
  { kind: box, at: [0.33, 0.09], size: [0.06, 0.16, 0.2], turn: -0.5, paint: (q) => (q[2] > 0.05 ? [40, 84, 170] : [230, 232, 236]) },
  { kind: revolve, at: [0.17, 0.16], profile: [[0.033, 0], [0.034, 0.12], [0.014, 0.165], [0.014, 0.2], [0, 0.2]], paint: (_, z) => (z > 0.16 ? [30, 50, 140] : [226, 178, 110]) },
  { kind: box, at: [-0.36, 0.06], size: [0.09, 0.14, 0.05], turn: 0.2, paint: () => [228, 228, 222] },
];

// A depth buffer of 2 mrad per pixel: a sample is visible if it faces the camera and is the nearest.
function visibleSamples(samples) {
  const nearest = new Map();
  const rays = samples.map(({ p }) => {
    const d = p.map((value, i) => value - CAMERA[i]);
    const depth = Math.hypot(...d);
    const key = `${Math.round(Math.atan2(d[0], d[1]) / 0.006)} ${Math.round(Math.asin(d[2] / depth) / 0.006)}`;
    nearest.set(key, Math.min(nearest.get(key) ?? Infinity, depth));
    return { key, depth, d };
  });
  return samples.map(({ n }, i) => {
    const { key, depth, d } = rays[i];
    const facing = -(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]) / depth;
    return facing > 0.12 && depth < nearest.get(key) + 0.012 / Math.max(facing, 0.12);
  });
}

function symmetries({ kind, at, turn = 0, size }) {
  const point = [...at, size ? size[2] / 2 : 0.1];
  if (kind === revolve) return { rotational: [{ point, direction: [0, 0, 1], residual: 0.012 }], reflectional: [] };
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return { rotational: [], reflectional: [{ point, normal: [c, s, 0], residual: 0.021 }, { point, normal: [-s, c, 0], residual: 0.034 }] };
}

// The class of a solid, its end hidden if it is the lowest box.
function classOf({ kind, at, turn = 0, size, profile }) {
  const name = kind === revolve ? 'cylinder' : 'box';
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const height = size ? size[2] : Math.max(...profile.map(([, z]) => z));
  const known = (dimension, value) => ({ name: dimension, value, sigma: 0.0012 });
  const dimensions = size
    ? [known('length', size[0]), size[2] < 0.1 ? { name: 'width', at_least: size[1] / 2, reason: 'an end is hidden' } : known('width', size[1])]
    : [known('radius', Math.max(...profile.map(([r]) => r)))];
  return {
    name, center: [...at, height / 2], axes: [[c, s, 0], [-s, c, 0], [0, 0, 1]], residual: 0.0006, explained: 0.98,
    dimensions: [...dimensions, known('height', height)],
  };
}

const REPORT = {
  timings: [
    { stage: 'downsample', seconds: 0.0042 }, { stage: 'occupancy', seconds: 0.021 },
    { stage: 'oversegmentation', seconds: 0.038 }, { stage: 'rotational', seconds: 0.187 },
    { stage: 'reflectional', seconds: 0.312 }, { stage: 'merge', seconds: 0.0011 }, { stage: 'completion', seconds: 0.046 },
  ],
  funnel: [
    { step: 'smooth segments', count: 40 }, { step: 'rotational: axis fits', count: 120 }, { step: 'rotational: distinct axes', count: 4 },
    { step: 'reflectional: planes tried', count: 600 }, { step: 'reflectional: with correspondences', count: 261 },
    { step: 'reflectional: that pass', count: 85 }, { step: 'reflectional: after merging', count: 46 }, { step: 'objects', count: 8 },
  ],
};

const EFFECTS = [
  { feature: 'axis_misfit', value: 0.012, median: 1, effect: 1.9 }, { feature: 'convexity', value: 0.98, median: 0.61, effect: 0.7 },
  { feature: 'near_others', value: 0.3, median: 0.1, effect: -0.4 },
];

// Of the hypotheses rejected by symmetry the points are known: those of the object in the middle.
function refusals(random, { points }) {
  const kinds = [['occlusion', 0.005], ['symmetry', 0.3], ['smoothness', 0.3], ['size', 200]];
  return Array.from({ length: 32 }, (_, i) => {
    const [reason, bound] = kinds[(i * i) % 4];
    const value = reason === 'size' ? Math.round(40 + 150 * random()) : bound * (1.1 + 2 * random());
    const known = reason === 'symmetry' ? { points, effects: EFFECTS } : {};
    return { kind: i % 5 ? 'reflectional' : 'rotational', reason, value, bound, size: Math.round(120 + 2500 * random()), ...known };
  });
}

const MEANINGS = { too_wide: 'too wide for the gripper', table: 'the gripper would hit the table', other_object: 'the gripper would hit another object' };
const GRIPPER = {
  name: 'panda', kind: 'parallel', max_opening: 0.08, finger_depth: 0.05, finger_width: 0.02, finger_thickness: 0.026,
  tip_thickness: 0.014, finger_spacing: 0, palm_size: [0.064, 0.208, 0.092],
};

/** Grasps of the solids thinner than the gripper opens: from above, and four from the side. */
function graspsOf(solids, gripper) {
  const [accepted, rejected] = [[], []];
  const summaries = solids.map(({ at, size, turn = 0, profile }, object) => {
    const [width, height] = size ? [Math.min(size[0], size[1]), size[2]]
      : [2 * Math.max(...profile.map(([r]) => r)), Math.max(...profile.map(([, z]) => z))];
    const across = !size || size[0] <= size[1] ? turn : turn + Math.PI / 2;
    const closing = [Math.cos(across), Math.sin(across), 0];
    const top = { object, position: [...at, height + 0.01], closing, approach: [0, 0, -1], opening: width, source: size ? 'box_face' : 'axis_top' };
    if (width > gripper.max_opening) {
      rejected.push({ ...top, quality: 0, reason: 'too_wide', value: width, bound: gripper.max_opening });
      return { candidates: 7, grasps: 0, rejected: { too_wide: 7 }, reason: 'too_wide' };
    }
    accepted.push({ ...top, quality: 0.95 - 0.1 * object });
    const sides = [0, 1, 2, 3].map((k) => {
      const approach = [Math.cos((k * Math.PI) / 2), Math.sin((k * Math.PI) / 2), 0];
      const position = [at[0] - 0.05 * approach[0], at[1] - 0.05 * approach[1], height / 2];
      return { ...top, position, approach, closing: [-approach[1], approach[0], 0], source: 'axis_side' };
    });
    sides.forEach((side, k) => accepted.push({ ...side, quality: 0.5 - 0.1 * k }));
    sides.forEach((side) => rejected.push({ ...side, position: [...side.position.slice(0, 2), 0.01], quality: 0, reason: 'table', value: -0.004, bound: 0.002 }));
    return { candidates: 25, grasps: 5, rejected: { table: 14, other_object: 6 }, reason: null };
  });
  accepted.sort((a, b) => b.quality - a.quality);
  return { gripper, accepted, rejected, objects: summaries, meanings: MEANINGS };
}

/** Views level with the table from four sides, the better the nearer to the front. */
function viewsAround() {
  const list = [0, 1, 2, 3].map((k) => {
    const [c, s] = [Math.cos((k * Math.PI) / 2), Math.sin((k * Math.PI) / 2)];
    const camera = { position: [0.6 * c, 0.6 * s, 0.2], right: [-s, c, 0], down: [0, 0, -1], forward: [-c, -s, 0] };
    return { candidate: 10 + k, camera, gain: 40 - 10 * k, inferred: 40 - 10 * k, disputed: 0, unknown: 0, cost: 0 };
  });
  return { policy: 'symmetry', unit: 'cm²', half_size: [0.6, 0.45], is_enough: false, list };
}

// Object 0 is true; the next two are one true object; the others are not in the ground truth, and one true object was not found.
function trueObjects([can, pan, cup, , , , , bar]) {
  const joined = [...pan.points, ...cup.points].sort((a, b) => a - b);
  return [{ name: 'can', points: can.points }, { name: 'pan with cup', points: joined }, { name: 'bar', points: bar.points.slice(0, 20) }, { name: 'spoon', points: [] }];
}

/** Five frames whose depth images differ. */
function playedSweep() {
  return sweep().cameras.slice(0, 5).map((camera, i) => (
    { camera, depth: { width: 8, height: 6, data: Uint8Array.from({ length: 48 }, (_, k) => (k % (i + 2) ? 40 * i + 60 : 0)) } }));
}

/** The scene as a payload. `clutter` adds points that are in no mask; `cell` is the cloud's grain;
 * `scan` adds the surface and the camera's path, `closed` the closed surfaces of the objects, `grasps` grasps
 * of a gripper with the given differences from a parallel one, `views` candidates for the next view, `compared` ground truth and
 * the frames of the sweep. */
export function tabletop({ title = 'Synthetic tabletop', seed = 7, clutter = 500, colors = true, cell = 0.008, scan = false, closed = false, grasps = null, views = false, compared = false } = {}) {
  const random = randomNumbers(seed);
  const parts = SOLIDS.map((solid) => thin(solid.kind(solid, cell, random), cell));
  const seen = visibleSamples(parts.flat());
  const cloud = { positions: [], normals: [], colors: [] };
  const add = (target, { p, n, c }) => {
    target.positions.push(p.map((value) => value + (random() - 0.5) * 0.001));
    target.normals.push(n);
    if (colors) target.colors?.push(c.map((value) => Math.min(255, Math.max(0, value + 18 * (random() - 0.5)))));
  };
  let offset = 0;
  const objects = parts.map((samples, id) => {
    const object = { points: [], score: 0.96 - 0.055 * id, completed: { positions: [], normals: [] }, ...symmetries(SOLIDS[id]) };
    samples.forEach((sample, i) => {
      if (!seen[offset + i]) return add(object.completed, sample);
      object.points.push(cloud.positions.length);
      add(cloud, sample);
    });
    offset += samples.length;
    if (closed) Object.assign(object, { class: classOf(SOLIDS[id]), closed: closedSurface(SOLIDS[id]), volume: 0.000412 });
    const { point } = (object.rotational[0] ?? object.reflectional[0]);
    const pose = { position: [...point.slice(0, 2), 0.1], orientation: [0, 0, 0, 1], size: [0.07, 0.08, 0.2] };
    return { ...object, centroid: point, pose, effects: EFFECTS };
  });
  for (let i = 0; i < clutter; ++i) {
    add(cloud, { p: [0.1 + 0.1 * random(), -0.32 + 0.03 * random(), 0.012], n: [0, 0, 1], c: [120, 124, 130] });
  }
  // Masks may overlap: the carton includes a few points of the can in front of it.
  objects[4].points = [...objects[0].points.slice(0, 8), ...objects[4].points];
  const around = scan ? { surface: scannedSurface(SOLIDS), trajectory: sweep() } : {};
  return encodeScene({ title, table: 0, cloud, objects, ...REPORT, ...around, grasps: grasps && graspsOf(SOLIDS, { ...GRIPPER, ...grasps }), views: views ? viewsAround() : null, rejected: refusals(random, objects[0]), ...(compared ? { truth: trueObjects(objects), sweep: playedSweep() } : {}) });
}

/** A scan in which nothing was found. */
export function emptyResult(title = 'Nothing found') {
  const scene = tabletop({ title });
  return { ...scene, objects: [], rejected: scene.rejected };
}

/** No point at all. */
export const noPoints = () => encodeScene({ title: 'No points', cloud: { positions: [] } });

/** A table on which nothing stands, from one frame. */
export function bareTable() {
  const { path, cameras } = sweep();
  return encodeScene({ title: 'Bare', table: 0, cloud: { positions: [] }, surface: scannedSurface([]),
    trajectory: { path: path.slice(0, 1), cameras: cameras.slice(0, 1) } });
}
