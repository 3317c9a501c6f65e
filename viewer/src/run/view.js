// One canvas with one or two views of the run: the true scene on the left, the believed one on the right. The camera is
// the same. Draws on demand.
import * as THREE from 'three';
import { Viewpoint } from '../camera.js';
import { h } from '../dom.js';
import { FIRST_DETAIL, detailFor, measured } from '../gl/detail.js';
import { Tags } from './tags.js';
import { World } from './world.js';

const MAX_PIXEL_RATIO = 2;
const CAPTION = 40; // height of the captions, which the framed part leaves free [CSS pixels]
const CONTROLS = 52; // height of the controls below

function createRenderer(canvas) {
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.shadowMap.enabled = true;
  renderer.autoClear = false;
  renderer.setScissorTest(true);
  return renderer;
}

export class RunView {
  frames = 0;
  afterDraw = [];

  constructor(recording, store) {
    this.store = store;
    this.world = new World(recording);
    this.canvas = h('canvas', { tabindex: '0', role: 'img', 'aria-label': 'The run in three dimensions: the true scene and what the robot believes' });
    this.tags = new Tags();
    this.element = h('div', { class: 'canvas' }, this.canvas, this.tags.element);
    this.renderer = createRenderer(this.canvas);
    this.requested = 0;
    this.restTimer = 0;
    this.detail = FIRST_DETAIL;
  }

  /** Starts to draw, when the element is in the page. */
  attach() {
    const { points, reach } = this.world.frame;
    this.viewpoint = new Viewpoint(this.canvas, points, reach);
    this.viewpoint.controls.zoomToCursor = false; // two views share the canvas
    this.viewpoint.onChange = () => this.invalidate();
    this.viewpoint.controls.addEventListener('change', () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.resize();
  }

  /** The drawn sides with their part of the canvas. [CSS pixels from the left] */
  get parts() {
    const { views } = this.store.get();
    const width = this.width / (views === 'both' ? 2 : 1);
    const sides = views === 'both' ? ['true', 'believed'] : [views];
    return sides.map((side, i) => ({ side, left: i * width, width }));
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0 || (width === this.width && height === this.height)) return;
    [this.width, this.height] = [width, height];
    this.renderer.setSize(width, height, false);
    this.#setDetail(1);
    this.reframe();
  }

  /** After a change of the size or the number of views. */
  reframe() {
    if (!this.width || !this.viewpoint) return;
    const [{ width }] = this.parts;
    this.viewpoint.camera.aspect = width / this.height;
    const free = { left: 6, top: CAPTION, width: Math.max(60, width - 12), height: Math.max(60, this.height - CAPTION - CONTROLS) };
    this.viewpoint.setViewport(width, this.height, free);
    if (this.frames > 0) this.draw(); // resizing clears the canvas, which would flicker until the next frame
    this.invalidate();
  }

  setScheme(scheme) {
    this.world.bodies.setScheme(scheme);
    this.invalidate();
  }

  invalidate() {
    if (!this.requested && this.viewpoint) this.requested = requestAnimationFrame(() => this.#tick());
  }

  #tick() {
    this.requested = 0;
    const moving = this.viewpoint.step() || this.store.get().playing;
    clearTimeout(this.restTimer);
    this.restTimer = 0;
    const isCoarse = this.detail.motionScale < 1;
    this.#setDetail(this.detail.motionScale);
    const delay = this.detail.restDelay;
    const isFirst = this.frames === 0; // it also compiles the shaders
    if (!isFirst && this.detail === FIRST_DETAIL) this.#measure();
    else this.draw();
    if (moving || isFirst) this.invalidate();
    else if (isCoarse) this.#restAfter(delay);
  }

  #restAfter(delay) {
    this.restTimer = setTimeout(() => { this.restTimer = 0; this.drawRested(); }, delay);
  }

  /** Whether nothing is drawn until something changes. */
  get isRested() {
    return !this.requested && !this.restTimer;
  }

  /** Draws the state at once, in place of the requested frames. */
  drawNow() {
    cancelAnimationFrame(this.requested);
    clearTimeout(this.restTimer);
    this.requested = this.restTimer = 0;
    const moving = this.viewpoint.step() || this.store.get().playing;
    this.drawRested();
    if (moving) this.invalidate();
  }

  /** Draws at once with all pixels of the screen. */
  drawRested() {
    this.#setDetail(1);
    this.draw();
  }

  #measure() {
    this.detail = detailFor(measured(this.renderer.getContext(), () => this.draw()));
  }

  #setDetail(scale) {
    const ratio = scale * Math.min(devicePixelRatio || 1, MAX_PIXEL_RATIO);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
  }

  draw() {
    const { time, labels } = this.store.get();
    this.world.setTime(time);
    this.world.marks?.show(this.store.get());
    this.renderer.setScissor(0, 0, this.width, this.height);
    this.renderer.clear();
    this.tags.begin();
    for (const part of this.parts) {
      this.#drawPart(part);
      if (labels) this.tags.place(this.world.tags(part.side, time), part, this.viewpoint.camera, this.height);
    }
    this.tags.end();
    this.frames += 1;
    for (const step of this.afterDraw) step();
  }

  #drawPart({ side, left, width }) {
    this.world.setSide(side);
    this.renderer.setViewport(left, 0, width, this.height);
    this.renderer.setScissor(left, 0, width, this.height);
    this.renderer.render(this.world.scene, this.viewpoint.camera);
  }
}
