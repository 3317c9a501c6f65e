// The camera: named views, exact framing, and animated changes of the view.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const DEGREE = Math.PI / 180;
const VIEWS = {
  home: { azimuth: 14, elevation: 33 },
  front: { azimuth: 0, elevation: 4 },
  side: { azimuth: 90, elevation: 4 },
  top: { azimuth: 0, elevation: 89.9 },
};
const FLIGHT = 380; // ms
const MARGIN = 1.1;

/** The key of each view. */
export const VIEW_KEYS = { h: 'home', f: 'front', s: 'side', t: 'top' };

export const isView = (name) => Object.hasOwn(VIEWS, name);

function directionOf({ azimuth, elevation }) {
  const [a, e] = [azimuth * DEGREE, elevation * DEGREE];
  return new THREE.Vector3(Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e));
}

/**
 * The nearest position that sees all `points` looking along −direction, and the point to orbit.
 * A point (a, b, c) in the camera's axes is in view from (x, y, z) if |a − x| ≤ tx (z − c), and so
 * for b: four half-spaces, each determined by one point.
 */
function frame(points, direction, tx, ty) {
  const right = new THREE.Vector3(0, 1, 0).cross(direction).normalize();
  const up = new THREE.Vector3().crossVectors(direction, right);
  const most = [-Infinity, -Infinity, -Infinity, -Infinity];
  let depth = 0;
  for (const [px, py, pz] of points) {
    const p = new THREE.Vector3(px, py, pz);
    const [a, b, c] = [p.dot(right), p.dot(up), p.dot(direction)];
    const values = [a + tx * c, -a + tx * c, b + ty * c, -b + ty * c];
    values.forEach((value, i) => { most[i] = Math.max(most[i], value); });
    depth += c / points.length;
  }
  const z = Math.max((most[0] + most[1]) / (2 * tx), (most[2] + most[3]) / (2 * ty));
  const at = (height) => new THREE.Vector3()
    .addScaledVector(right, (most[0] - most[1]) / 2)
    .addScaledVector(up, (most[2] - most[3]) / 2)
    .addScaledVector(direction, height);
  return { position: at(z), target: at(depth) };
}

export class Viewpoint {
  constructor(stageElement, points, reach) {
    this.points = points;
    this.camera = new THREE.PerspectiveCamera(26, 1, 0.01, 100);
    this.controls = new OrbitControls(this.camera, stageElement);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.14;
    this.controls.zoomToCursor = true;
    this.flight = null;
    this.view = 'home';
    this.listeners = []; // called when the view is set otherwise than by dragging
    const radius = Math.max(0.05, ...points.map((p) => Math.hypot(...p)));
    this.radius = radius;
    this.reach = reach; // largest distance of drawn points from the origin
    this.controls.minDistance = 0.05 * radius;
    this.controls.maxDistance = 25 * radius;
    this.controls.addEventListener('start', () => { this.flight = null; this.view = null; });
  }

  /** `free` is the part of the canvas that no panel covers, in CSS pixels. */
  setViewport(width, height, free) {
    const dx = free.left + free.width / 2 - width / 2;
    const dy = free.top + free.height / 2 - height / 2;
    this.camera.setViewOffset(width, height, -dx, -dy, width, height);
    const t = Math.tan((this.camera.fov * DEGREE) / 2);
    this.ty = ((t * free.height) / height) / MARGIN;
    this.tx = (this.ty * free.width) / free.height;
    if (this.view) this.go(this.view, false);
  }

  /** Sets the points that all views frame, and frames them; after a dragging, from its direction, if `always`. */
  show(points, always = false) {
    this.points = points;
    if (this.view) this.go(this.view);
    else if (always) this.focus(points, 1);
  }

  /** Looks from a position at a target. */
  look(position, target) {
    this.view = null;
    this.#fly({ position: new THREE.Vector3(...position), target: new THREE.Vector3(...target) }, false);
  }

  go(view, animate = true, points = this.points) {
    this.view = view;
    this.#fly(frame(points, directionOf(VIEWS[view]), this.tx, this.ty), animate);
  }

  /** Frames some points from the current direction. */
  focus(points, zoom = 0.55) {
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    this.view = null;
    this.#fly(frame(points, direction, this.tx * zoom, this.ty * zoom), true);
  }

  #fly(goal, animate) {
    const still = !animate || matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.flight = {
      goal,
      from: { position: this.camera.position.clone(), target: this.controls.target.clone() },
      begin: still ? -Infinity : performance.now(),
    };
    if (still) this.step();
    this.#changed();
  }

  orbit(azimuth, elevation) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const polar = new THREE.Spherical().setFromVector3(offset);
    polar.theta += azimuth * DEGREE;
    polar.phi = Math.min(Math.max(polar.phi - elevation * DEGREE, 1e-3), Math.PI - 1e-3);
    this.#move(this.controls.target.clone().add(offset.setFromSpherical(polar)));
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    offset.clampLength(this.controls.minDistance, this.controls.maxDistance);
    this.#move(this.controls.target.clone().add(offset));
  }

  pan(right, up) {
    const distance = 0.05 * this.camera.position.distanceTo(this.controls.target);
    const shift = new THREE.Vector3(right * distance, up * distance, 0).applyQuaternion(this.camera.quaternion);
    this.controls.target.add(shift);
    this.#move(this.camera.position.clone().add(shift));
  }

  #move(position) {
    this.flight = null;
    this.view = null;
    this.camera.position.copy(position);
    this.#changed();
  }

  #changed() {
    this.onChange?.();
    for (const listener of this.listeners) listener();
  }

  /** Advances the animation; true while the camera moves. */
  step() {
    const flying = this.#stepFlight();
    const before = this.camera.position.clone();
    this.controls.update();
    const distance = this.camera.position.length();
    this.camera.near = Math.max(distance - Math.max(2.5 * this.radius, this.reach), 0.01 * this.radius);
    this.camera.far = distance + Math.max(6 * this.radius, this.reach);
    this.camera.updateProjectionMatrix();
    return flying || before.distanceToSquared(this.camera.position) > 1e-14;
  }

  #stepFlight() {
    if (!this.flight) return false;
    const { goal, from, begin } = this.flight;
    const t = Math.min(1, (performance.now() - begin) / FLIGHT);
    const eased = 1 - (1 - t) ** 3;
    this.camera.position.lerpVectors(from.position, goal.position, eased);
    this.controls.target.lerpVectors(from.target, goal.target, eased);
    if (t === 1) this.flight = null;
    return t < 1;
  }
}
