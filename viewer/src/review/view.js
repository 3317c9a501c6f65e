// The picture of one model with its symmetries. Draws on demand.
import * as THREE from 'three';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';
import { Viewpoint } from '../camera.js';
import { h } from '../dom.js';
import { Symmetries } from '../gl/symmetries.js';
import { css } from '../palette.js';
import { add, scale } from '../vector.js';
import { SIZE, tagOf } from './models.js';
import { motionOf } from './motions.js';

const CREASE = 0.7; // edges sharper than this are drawn sharp [rad]
const SURFACE = { light: 0xb9c2ce, dark: 0x8c97a6 };
const COPY = 0xf08a24;
const COPY_SHIFT = 0.01 * SIZE; // away from the camera, so that what sticks out by less stays hidden
const FRAMED = 1.3; // of the model's size, for the ends of axes and planes
const MAX_PIXEL_RATIO = 2;

function geometryOf({ positions, triangles }) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  if (!triangles) return geometry;
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  return toCreasedNormals(geometry, CREASE);
}

function materialOf(model, color) {
  if (!model.triangles) return new THREE.PointsMaterial({ color, size: 0.0025 });
  return new THREE.MeshStandardMaterial({
    color, roughness: 0.75, metalness: 0, side: THREE.DoubleSide,
  });
}

function drawable(model, geometry, color) {
  const material = materialOf(model, color);
  return model.triangles ? new THREE.Mesh(geometry, material) : new THREE.Points(geometry, material);
}

function matrixOf({ columns, shift }) {
  return new THREE.Matrix4().makeBasis(...columns.map((column) => new THREE.Vector3(...column)))
    .setPosition(...shift);
}

function createLights(camera) {
  const lamp = new THREE.DirectionalLight(0xffffff, 2.0);
  lamp.position.set(-0.4, 0.7, 1);
  camera.add(lamp, lamp.target);
  return [new THREE.HemisphereLight(0xffffff, 0x8a8f99, 1.5), camera];
}

// The three axes of a sphere stand for all.
function partsOf({ kind, point, direction }) {
  if (kind === 'plane') return { planes: [{ point, normal: direction }], axes: [] };
  const directions = kind === 'sphere' ? [[1, 0, 0], [0, 1, 0], [0, 0, 1]] : [direction];
  return { planes: [], axes: directions.map((each) => ({ point, direction: each })) };
}

/** Where the tag of an axis stands: beyond its upper end. */
function tagPoint({ point, direction }, outline) {
  const up = direction[1] < 0 ? scale(direction, -1) : direction;
  const along = outline.map((p) => up.reduce((sum, u, k) => sum + u * (p[k] - point[k]), 0));
  return add(point, scale(up, Math.max(...along) + 0.05));
}

export class View {
  frames = 0;

  constructor() {
    this.canvas = h('canvas', { tabindex: '0', role: 'img', 'aria-label': 'The model in three dimensions' });
    this.tags = h('div');
    this.element = h('div', { class: 'view' }, this.canvas, this.tags);
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
    this.scene = new THREE.Scene();
    this.requested = 0;
  }

  attach() {
    this.viewpoint = new Viewpoint(this.canvas, [[0.15, 0.15, 0.15]], 0.3);
    this.scene.add(...createLights(this.viewpoint.camera));
    this.viewpoint.onChange = () => this.invalidate();
    this.viewpoint.controls.addEventListener('change', () => this.invalidate());
    new ResizeObserver(() => this.#resize()).observe(this.element);
    this.#resize();
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, MAX_PIXEL_RATIO));
    this.renderer.setSize(width, height, false);
    this.viewpoint.camera.aspect = width / height;
    this.viewpoint.setViewport(width, height, { left: 0, top: 0, width, height });
    this.invalidate();
  }

  #clear() {
    if (!this.group) return;
    this.scene.remove(this.group);
    this.group.traverse((object) => {
      object.geometry?.dispose();
      object.material?.dispose();
    });
  }

  /** Shows another model from the front. */
  show(model) {
    this.#clear();
    this.model = model;
    const geometry = geometryOf(model);
    this.surface = drawable(model, geometry, SURFACE[this.scheme]);
    this.copy = drawable(model, geometry, COPY);
    this.copy.matrixAutoUpdate = false;
    this.symmetries = model.shown.map((each) => new Symmetries(partsOf(each), model.outline, each.color));
    this.group = new THREE.Group().add(this.surface, this.copy,
      ...this.symmetries.flatMap(({ planes, axes }) => [planes, axes]));
    this.scene.add(this.group);
    this.#createTags(model);
    this.setScheme(this.scheme);
    this.viewpoint.points = model.outline.map((p) => scale(p, FRAMED));
    this.viewpoint.go('home', false);
  }

  #createTags({ shown, outline }) {
    this.tagged = shown.map((symmetry) => ({
      at: new THREE.Vector3(...tagPoint(symmetry, outline)),
      element: h('span', { class: 'tag', style: { '--color': css(symmetry.color) } }, tagOf(symmetry)),
      named: tagOf(symmetry) !== '',
    }));
    this.tags.replaceChildren(...this.tagged.map(({ element }) => element));
  }

  setScheme(scheme) {
    this.scheme = scheme;
    this.surface?.material.color.set(SURFACE[scheme]);
    for (const symmetry of this.symmetries ?? []) symmetry.setScheme(scheme, scheme === 'dark' ? [28, 32, 39] : [236, 239, 244]);
    this.invalidate();
  }

  /** `selected` is the index of a symmetry or null; rejected ones are drawn only when selected. */
  update({ selected, rejected, copied }) {
    this.symmetries.forEach((symmetry, index) => {
      const shows = index === selected || !rejected(index);
      symmetry.show(shows, shows, index === selected ? 'strong' : 'faint');
      this.tagged[index].shows = shows && this.tagged[index].named;
      this.tagged[index].element.style.opacity = index === selected ? 1 : 0.55;
    });
    this.copy.visible = copied && selected !== null;
    if (this.copy.visible) this.motion = matrixOf(motionOf(this.model.shown[selected]));
    this.invalidate();
  }

  invalidate() {
    if (!this.requested && this.viewpoint) this.requested = requestAnimationFrame(() => this.#tick());
  }

  #tick() {
    this.requested = 0;
    const moving = this.viewpoint.step();
    this.draw();
    if (moving) this.invalidate();
  }

  draw() {
    const { camera } = this.viewpoint;
    if (this.copy?.visible) {
      const away = camera.getWorldDirection(new THREE.Vector3()).multiplyScalar(COPY_SHIFT);
      this.copy.matrix.makeTranslation(away).multiply(this.motion);
    }
    this.renderer.render(this.scene, camera);
    for (const { at, element, shows } of this.tagged ?? []) {
      const p = at.clone().project(camera);
      element.hidden = !shows || p.z > 1;
      const x = ((p.x + 1) / 2) * this.element.clientWidth;
      const y = ((1 - p.y) / 2) * this.element.clientHeight;
      element.style.transform = `translate(${x}px, ${y}px) translate(-50%, -50%)`;
    }
    this.frames += 1;
  }
}
