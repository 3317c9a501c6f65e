// A recorded run: an arm of capsules carries boxes and cans from a table into a bin. Frame of the table: z up.
import { encodeRun } from './payload.mjs';
import { add, box, capsule, cylinder, moved, subtract, turnZ } from './run_meshes.mjs';

const RATE = 10; // moments per second
const BASE = [-0.5, 0, 0];
const SHOULDER = 0.33;
const LINKS = [0.42, 0.42]; // upper arm, forearm [m]
const HAND = 0.16; // from the wrist down to the grasp [m]
const BIN = [-0.15, -0.5, 0];
const HOME = [-0.2, 0.1, 0.5];

const OBJECTS = [
  { name: 'cereal', at: [0.05, 0.14], turn: 0.4, size: [0.05, 0.13, 0.18] },
  { name: 'can', at: [0.12, -0.06], turn: 0, radius: 0.033, height: 0.12 },
  { name: 'sugar', at: [-0.06, -0.02], turn: -0.5, size: [0.04, 0.09, 0.17] },
  { name: 'tuna', at: [0.02, -0.17], turn: 0, radius: 0.04, height: 0.034 },
  { name: 'brick', at: [0.2, 0.1], turn: 0.9, size: [0.06, 0.2, 0.07] },
  { name: 'crate', at: [0.27, -0.16], turn: 0.2, size: [0.16, 0.16, 0.11] },
];
const heightOf = ({ size, height }) => size?.[2] ?? height;
const meshOf = (object) => (object.size ? box(object.size) : cylinder(object.radius, object.height));

/** A turn by `pitch` about y, then by `yaw` about z, as a quaternion. */
function turn(yaw, pitch) {
  const [cy, sy, cp, sp] = [Math.cos(yaw / 2), Math.sin(yaw / 2), Math.cos(pitch / 2), Math.sin(pitch / 2)];
  return [-sy * sp, cy * sp, sy * cp, cy * cp];
}

/** Yaw and the pitches of both links, from upright, that bring the wrist to a point. */
function reach(wrist) {
  const [dx, dy, dz] = subtract(wrist, add(BASE, [0, 0, SHOULDER]));
  const [a, b] = LINKS;
  const flat = Math.hypot(dx, dy);
  const distance = Math.min(Math.hypot(flat, dz), 0.999 * (a + b));
  const inner = Math.acos((a * a + distance * distance - b * b) / (2 * a * distance));
  const elbow = Math.acos((a * a + b * b - distance * distance) / (2 * a * b));
  const upper = Math.atan2(flat, dz) - inner;
  return { yaw: Math.atan2(dy, dx), upper, fore: upper + Math.PI - elbow };
}

const along = (yaw, pitch, length) => [length * Math.sin(pitch) * Math.cos(yaw), length * Math.sin(pitch) * Math.sin(yaw), length * Math.cos(pitch)];
const pose = (position, rotation = [0, 0, 0, 1]) => ({ position, rotation });

function robotPoses(grasp, opening) {
  const wrist = add(grasp, [0, 0, HAND]);
  const { yaw, upper, fore } = reach(wrist);
  const shoulder = add(BASE, [0, 0, SHOULDER]);
  const elbow = add(shoulder, along(yaw, upper, LINKS[0]));
  const finger = (side) => pose(add(grasp, [0, (side * opening) / 2, 0]));
  return [pose(BASE), pose(shoulder, turn(yaw, upper)), pose(elbow, turn(yaw, fore)), pose(wrist), finger(1), finger(-1)];
}

const ROBOT = [
  { name: 'base', kind: 'robot', mesh: capsule(0.09, SHOULDER) },
  { name: 'upper arm', kind: 'robot', mesh: capsule(0.06, LINKS[0]) },
  { name: 'forearm', kind: 'robot', mesh: capsule(0.05, LINKS[1]) },
  { name: 'palm', kind: 'hand', mesh: moved(box([0.06, 0.18, 0.06]), [0, 0, -0.09]) },
  { name: 'left finger', kind: 'hand', mesh: moved(box([0.02, 0.012, 0.07]), [0, 0.006, 0]) },
  { name: 'right finger', kind: 'hand', mesh: moved(box([0.02, 0.012, 0.07]), [0, -0.006, 0]) },
];

function binMesh() {
  const wall = (size, at) => moved(box(size), at);
  return [wall([0.3, 0.24, 0.01], [0, 0, 0]), wall([0.3, 0.01, 0.12], [0, 0.12, 0]), wall([0.3, 0.01, 0.12], [0, -0.12, 0]),
    wall([0.01, 0.24, 0.12], [0.15, 0, 0]), wall([0.01, 0.24, 0.12], [-0.15, 0, 0])].reduce((all, mesh) => ({
    positions: all.positions.concat(mesh.positions),
    triangles: all.triangles.concat(mesh.triangles.map((t) => t.map((i) => i + all.positions.length))),
  }));
}

class Recording {
  times = [];
  poses = [];
  beliefs = [];
  events = [];
  hand = HOME;
  opening = 0.08;
  held = null;

  constructor() {
    this.objects = OBJECTS.map(({ at, turn: yaw }) => ({ ...pose([...at, 0], turn(yaw, 0)) }));
    this.gone = new Set();
  }

  get time() { return this.times.length / RATE; }

  moment() {
    this.times.push(this.time);
    this.poses.push([...robotPoses(this.hand, this.opening), ...this.objects.map((each) => ({ ...each })), pose(BIN), pose([0.1, 0, 0])]);
  }

  /** The hand, and what it holds, goes straight and smoothly. */
  move(goal, seconds, opening = this.opening) {
    const [from, wide] = [this.hand, this.opening];
    for (let i = 1; i <= seconds * RATE; ++i) {
      const t = i / (seconds * RATE);
      const eased = t * t * (3 - 2 * t);
      const before = this.hand;
      this.hand = from.map((value, k) => value + eased * (goal[k] - value));
      this.opening = wide + eased * (opening - wide);
      if (this.held !== null) this.objects[this.held].position = add(this.objects[this.held].position, subtract(this.hand, before));
      this.moment();
    }
  }

  fall(index, floor) {
    for (let v = 0; this.objects[index].position[2] > floor; v += 9.81 / RATE) {
      const [x, y, z] = this.objects[index].position;
      this.objects[index].position = [x, y, Math.max(floor, z - v / RATE)];
      this.moment();
    }
  }

  say(text, outcome = 'note') { this.events.push({ time: this.time, text, outcome }); }

  look() {
    const objects = OBJECTS.map((object, index) => ({ object, index })).filter(({ index }) => !this.gone.has(index)).map(({ object, index }) => {
      const [x, y, z] = this.objects[index].position;
      const seen = turnZ(meshOf(object), object.turn + 0.02);
      return { name: `object ${index + 1}`, label: `${object.size ? 'box' : 'cylinder'} 0.${92 - 7 * index}`, mesh: moved(seen, [x + 0.004, y - 0.003, z]) };
    });
    if (this.beliefs.length === 0) objects.push({ name: 'object 9', label: 'cylinder 0.51', mesh: moved(cylinder(0.03, 0.08), [0.1, 0.3, 0]) });
    this.say(`Look ${this.beliefs.length + 1}: ${objects.length} objects`);
    this.beliefs.push({ time: this.time, objects });
  }

  pick(index, slips = false) {
    const object = OBJECTS[index];
    const [x, y, z] = this.objects[index].position;
    const grasp = [x, y, z + 0.75 * heightOf(object)];
    this.look();
    this.move(add(grasp, [0, 0, 0.15]), 1.5);
    this.move(grasp, 0.8);
    this.move(grasp, 0.4, Math.min(0.07, object.size?.[0] ?? 2 * object.radius));
    this.held = index;
    this.move(add(grasp, [0, 0, 0.06]), 0.5);
    if (slips) return this.drop(index, 0, `The ${object.name} slipped out of the hand`, 'failure');
    this.move(add(BIN, [0.02 * index - 0.04, 0.02 * index - 0.05, 0.3]), 2);
    this.gone.add(index);
    return this.drop(index, 0.01, `Picked the ${object.name}`, 'success');
  }

  drop(index, floor, text, outcome) {
    this.held = null;
    this.opening = 0.08;
    this.fall(index, floor);
    this.say(text, outcome);
    this.move(HOME, 1);
  }
}

/** Four of six objects are picked, with one failure. */
export function recordedRun({ title = 'Panda clears a table' } = {}) {
  const run = new Recording();
  run.moment();
  run.pick(0);
  run.pick(1, true);
  for (const index of [1, 2, 3]) run.pick(index);
  run.look();
  run.say('Nothing graspable is left');
  run.move(HOME, 1);
  const solids = [...ROBOT, ...OBJECTS.map((object) => ({ name: object.name, kind: 'object', mesh: meshOf(object) })),
    { name: 'bin', kind: 'bin', mesh: binMesh() }, { name: 'table', kind: 'table', mesh: moved(box([1.5, 1.3, 0.03]), [0, 0, -0.03]) }];
  return encodeRun({ title, solids, times: run.times, poses: run.poses, beliefs: run.beliefs, events: run.events,
    left: ['brick: every grasp within reach meets the crate', 'crate: too wide for the gripper, 160.0 mm > 80.0 mm'] });
}
