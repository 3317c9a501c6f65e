// The points of an update, each object in its own colour, and the numbers of the objects. Draws on demand.
import * as THREE from 'three';
import { Viewpoint } from '../camera.js';
import { h } from '../dom.js';
import { objectColor } from '../palette.js';
import { Tags } from '../run/tags.js';

const MAX_PIXEL_RATIO = 2;
const REST = [150, 156, 166]; // points of no object without a colour of their own

/** Turns the world so that the table's normal is up, with the middle of the points at the origin. */
function frameOf({ positions, report }) {
  const normal = new THREE.Vector3(...(report.table ?? [0, 0, 1]).slice(0, 3)).normalize();
  const turn = new THREE.Quaternion().setFromUnitVectors(normal, new THREE.Vector3(0, 1, 0));
  const box = new THREE.Box3().setFromArray(positions);
  const middle = box.isEmpty() ? new THREE.Vector3() : box.getCenter(new THREE.Vector3());
  return new THREE.Matrix4().makeRotationFromQuaternion(turn).multiply(new THREE.Matrix4().makeTranslation(middle.negate()));
}

function colorsOf({ numbers, colors }) {
  const bytes = new Uint8Array(3 * numbers.length);
  for (let i = 0; i < numbers.length; ++i) {
    const own = colors ? colors.subarray(3 * i, 3 * i + 3) : REST;
    bytes.set(numbers[i] ? objectColor(numbers[i] - 1) : own, 3 * i);
  }
  return bytes;
}

export class LiveView {
  frames = 0;

  constructor() {
    this.canvas = h('canvas', { tabindex: '0', role: 'img', 'aria-label': 'The points of the scene, each object in its own colour' });
    this.tags = new Tags();
    this.element = h('div', { class: 'canvas' }, this.canvas, this.tags.element);
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
    this.material = new THREE.PointsMaterial({ size: 0.006, vertexColors: true });
    this.points = new THREE.Points(new THREE.BufferGeometry(), this.material);
    this.points.frustumCulled = false;
    this.root = new THREE.Group().add(this.points);
    this.root.matrixAutoUpdate = false;
    this.scene = new THREE.Scene().add(this.root);
    this.requested = 0;
    this.objects = [];
  }

  attach() {
    this.viewpoint = new Viewpoint(this.canvas, [[-0.3, 0, -0.3], [0.3, 0.3, 0.3]], 3);
    this.viewpoint.onChange = () => this.invalidate();
    this.viewpoint.controls.addEventListener('change', () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0) return;
    [this.width, this.height] = [width, height];
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, MAX_PIXEL_RATIO));
    this.renderer.setSize(width, height, false);
    this.viewpoint.camera.aspect = width / height;
    this.viewpoint.setViewport(width, height, { left: 12, top: 48, width: Math.max(60, width - 24), height: Math.max(60, height - 60) });
    this.invalidate();
  }

  /** The frame of the view stays that of the first update with points, so that nothing jumps. */
  show(update) {
    const { positions, numbers, size, report } = update;
    if (!this.frame && numbers.length > 0) this.#chooseFrame(update);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(colorsOf(update), 3, true));
    this.points.geometry.dispose();
    this.points.geometry = geometry;
    this.material.size = 1.2 * (report.spacing || 0.005) * Math.sqrt(Math.max(1, size / Math.max(1, numbers.length)));
    this.objects = report.objects;
    this.invalidate();
  }

  #chooseFrame(update) {
    this.frame = frameOf(update);
    this.root.matrix.copy(this.frame);
    this.root.matrixWorldNeedsUpdate = true;
    const box = new THREE.Box3().setFromArray(update.positions).applyMatrix4(this.frame);
    const [low, high] = [box.min.toArray(), box.max.toArray()];
    this.viewpoint.radius = Math.max(0.05, ...[low, high].map((corner) => Math.hypot(...corner)));
    this.viewpoint.reach = 4 * this.viewpoint.radius;
    this.viewpoint.show([0, 1, 2, 3, 4, 5, 6, 7].map((i) => [0, 1, 2].map((k) => (i >> k & 1 ? high[k] : low[k]))), true);
  }

  #labels() {
    if (!this.frame) return [];
    return this.objects.map(({ number, center }) => ({ text: String(number), at: new THREE.Vector3(...center).applyMatrix4(this.frame).toArray() }));
  }

  invalidate() {
    if (!this.requested && this.viewpoint) this.requested = requestAnimationFrame(() => this.#tick());
  }

  #tick() {
    this.requested = 0;
    const moving = this.viewpoint.step();
    this.renderer.render(this.scene, this.viewpoint.camera);
    this.tags.begin();
    this.tags.place(this.#labels(), { left: 0, width: this.width }, this.viewpoint.camera, this.height);
    this.tags.end();
    this.frames += 1;
    if (moving) this.invalidate();
  }
}
