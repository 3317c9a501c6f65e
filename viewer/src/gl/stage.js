// The canvas: table, cloud and mesh in two passes, then lines and sheets. Draws on demand.
import * as THREE from 'three';
import { FIRST_DETAIL, detailFor, measured } from './detail.js';
import { composeFragment, composeVertex } from './shaders.js';

const MAX_PIXEL_RATIO = 2;

function createTarget(type) {
  return new THREE.WebGLRenderTarget(2, 2, {
    type,
    minFilter: THREE.NearestFilter,
    magFilter: THREE.NearestFilter,
    depthBuffer: type === THREE.UnsignedByteType,
  });
}

// Render targets: marks and depth of the nearest surface, and the weighted sum of its colours.
function createTargets() {
  const surface = createTarget(THREE.UnsignedByteType);
  surface.depthTexture = new THREE.DepthTexture(2, 2, THREE.UnsignedIntType);
  return { surface, colors: createTarget(THREE.HalfFloatType) };
}

function createCompose({ surface, colors }) {
  const material = new THREE.ShaderMaterial({
    vertexShader: composeVertex,
    fragmentShader: composeFragment,
    uniforms: {
      marks: { value: surface.texture },
      colors: { value: colors.texture },
      depths: { value: surface.depthTexture },
      samples: { value: 1 },
      near: { value: 0.1 },
      far: { value: 10 },
      reach: { value: 1 },
      strength: { value: 9 },
      outline: { value: new THREE.Color(0, 0, 0) },
      outlined: { value: false },
    },
    depthFunc: THREE.AlwaysDepth,
    transparent: true,
    premultipliedAlpha: true,
  });
  const triangle = new THREE.BufferGeometry();
  triangle.setAttribute('position', new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  const mesh = new THREE.Mesh(triangle, material);
  mesh.frustumCulled = false;
  const scene = new THREE.Scene();
  scene.add(mesh);
  return { scene, uniforms: material.uniforms };
}

function createRenderer(canvas) {
  const renderer = new THREE.WebGLRenderer({
    canvas, alpha: true, antialias: true, powerPreference: 'high-performance',
  });
  renderer.autoClear = false;
  renderer.setClearColor(0x000000, 0);
  return renderer;
}

export class Stage {
  ground = new THREE.Scene();
  cloud = new THREE.Scene();
  overlay = new THREE.Scene();
  beforeDraw = []; // callbacks; each returns true while it animates
  afterDraw = [];
  frames = 0;

  constructor(canvas, camera) {
    this.camera = camera;
    this.renderer = createRenderer(canvas);
    this.targets = createTargets();
    this.compose = createCompose(this.targets);
    this.requested = 0;
    this.restTimer = 0;
    this.detail = FIRST_DETAIL;
  }

  /** [CSS pixels] The first call of an observer of the size reports what is known. */
  resize(width, height) {
    if (width === this.width && height === this.height) return;
    this.width = width;
    this.height = height;
    this.renderer.setSize(width, height, false);
    this.#setDetail(1);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.frames > 0) this.draw(1); // resizing clears the canvas, which would flicker until the next frame
    this.invalidate();
  }

  setOutline(color) {
    this.compose.uniforms.outline.value.setRGB(...color.map((value) => value / 255));
  }

  setOutlined(outlined) {
    this.compose.uniforms.outlined.value = outlined;
  }

  /** Requests a picture at the next frame of the screen. */
  invalidate() {
    if (!this.requested) this.requested = requestAnimationFrame(() => this.#tick());
  }

  #tick() {
    this.requested = 0;
    const moving = this.#step();
    clearTimeout(this.restTimer);
    this.restTimer = 0;
    this.#setDetail(this.detail.motionScale);
    const delay = this.detail.restDelay;
    const isFirst = this.frames === 0; // it also compiles the shaders
    if (!isFirst && this.detail === FIRST_DETAIL) this.#measure();
    else this.draw(1);
    if (moving || isFirst) this.invalidate();
    else this.#restAfter(delay);
  }

  #restAfter(delay) {
    this.restTimer = setTimeout(() => { this.restTimer = 0; this.drawRested(); }, delay);
  }

  /** Whether nothing is drawn until something changes. */
  get isRested() {
    return !this.requested && !this.restTimer;
  }

  #step() {
    return this.beforeDraw.map((step) => step()).some(Boolean);
  }

  /** Draws the state at once, in place of the requested frames. */
  drawNow(samples) {
    cancelAnimationFrame(this.requested);
    clearTimeout(this.restTimer);
    this.requested = this.restTimer = 0;
    const moving = this.#step();
    this.drawRested(samples);
    if (moving || samples !== this.#restSamples()) this.invalidate();
  }

  /** Draws at once with all pixels of the screen. */
  drawRested(samples) {
    this.#setDetail(1);
    this.draw(samples);
  }

  #measure() {
    this.detail = detailFor(measured(this.renderer.getContext(), () => this.draw(1)));
  }

  #setDetail(scale) {
    const ratio = scale * Math.min(devicePixelRatio || 1, MAX_PIXEL_RATIO);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
  }

  // A still picture gets four samples per pixel unless the screen's density provides them or they would take long.
  #restSamples() {
    return this.renderer.getPixelRatio() > 1.5 ? 1 : this.detail.restSamples;
  }

  /** Draws at once, with samples² texels per pixel. */
  draw(samples = this.#restSamples()) {
    const { renderer, camera } = this;
    const pixels = renderer.getDrawingBufferSize(new THREE.Vector2()).multiplyScalar(samples);
    camera.updateMatrixWorld();
    this.#drawCloud(pixels);
    renderer.setRenderTarget(null);
    renderer.clear();
    renderer.render(this.ground, camera);
    this.#composeOnto(camera, samples);
    renderer.render(this.overlay, camera);
    this.frames += 1;
    for (const step of this.afterDraw) step();
  }

  #drawCloud(pixels) {
    const { renderer, camera, targets } = this;
    const focal = pixels.y / (2 * Math.tan(THREE.MathUtils.degToRad(camera.fov / 2)));
    for (const pass of ['depth', 'color']) {
      const target = pass === 'depth' ? targets.surface : targets.colors;
      target.setSize(pixels.x, pixels.y);
      for (const { userData: { layer } } of this.cloud.children) {
        const { uniforms } = layer.materials;
        if (uniforms.focal) uniforms.focal.value = focal;
        uniforms.near.value = camera.near;
        uniforms.far.value = camera.far;
        // A texture must not be read while it is drawn to.
        uniforms.depths.value = pass === 'depth' ? null : targets.surface.depthTexture;
      }
      for (const object of this.cloud.children) object.material = object.userData.layer.materials[pass];
      renderer.setRenderTarget(target);
      renderer.clear();
      renderer.render(this.cloud, camera);
    }
  }

  #composeOnto(camera, samples) {
    const { uniforms, scene } = this.compose;
    uniforms.samples.value = samples;
    uniforms.near.value = camera.near;
    uniforms.far.value = camera.far;
    uniforms.reach.value = 1.4 * samples * this.renderer.getPixelRatio();
    this.renderer.render(scene, camera);
  }
}
