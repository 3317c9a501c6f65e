// window.symscene: the interface for tests and for scripts that take pictures.

import { hashOf } from './address.js';
import { glbOf } from './glb.js';
import { pictureOf } from './picture.js';
import { initialState } from './store.js';

// A pixel that picks the object, near the centre of its pickable pixels.
function clickPoint(app, index) {
  const { positions, owners } = app.drawing.cloud;
  const project = app.layout.project();
  const { left, top, right, bottom } = app.layout.free();
  const seen = [];
  for (let i = 0; i < owners.length; ++i) {
    if (owners[i] !== index) continue;
    const p = project(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
    if (p && p.x > left && p.x < right && p.y > top && p.y < bottom) seen.push(p);
  }
  const mean = (key) => seen.reduce((sum, p) => sum + p[key], 0) / seen.length;
  const [x, y] = [mean('x'), mean('y')];
  const far = (p) => (p.x - x) ** 2 + (p.y - y) ** 2;
  const nearest = seen.sort((a, b) => far(a) - far(b))[0];
  return nearest ? { x: nearest.x, y: nearest.y } : null;
}

// The share of pixels of the canvas that are not empty, and a hash of all pixels.
function readPixels({ stage }) {
  stage.drawNow(1);
  const gl = stage.renderer.getContext();
  const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
  const bytes = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  let filled = 0;
  let hash = 0;
  for (let i = 0; i < bytes.length; i += 4) {
    if (bytes[i + 3] > 200) filled += 1;
    hash = (Math.imul(hash, 31) + bytes[i] + 7 * bytes[i + 1] + 13 * bytes[i + 2]) | 0;
  }
  return { filled: filled / (width * height), hash };
}

export function createHook(app) {
  const { store, objects, stage, viewpoint } = app;
  const indexOf = (id) => objects.find((object) => object.id === id)?.index ?? null;
  const ids = (set) => objects.filter(({ index }) => set.has(index)).map(({ id }) => id);
  window.symscene = {
    ready: new Promise((resolve) => {
      const check = () => (stage.frames >= 3 && stage.detail.restDelay > 0 ? resolve(true) : requestAnimationFrame(check));
      check();
    }),
    get selected() { return objects[store.get().selected]?.id ?? null; },
    get visible() { return ids(store.get().visible); },
    get completed() { return ids(store.get().completed); },
    get shapes() {
      const { shapes } = app.drawing;
      return objects.filter(({ index }) => shapes[index].object.visible && !shapes[index].isEmpty).map(({ id }) => id);
    },
    get mode() { return store.get().mode; },
    get mesh() { return app.drawing.surface !== null && store.get().mesh; },
    get path() { return app.drawing.trajectory !== null && store.get().path; },
    /** The keys of the drawn grasps: "a3" is the fourth of all accepted ones. */
    get grasps() { return (app.drawing.drawnGrasps ?? []).map(([key]) => key); },
    get grasp() { return store.get().grasp; },
    /** Whether the views are drawn, and the rank of the chosen one. */
    get views() { return app.drawing.views !== null && store.get().views; },
    get chosenView() { return store.get().view; },
    /** The number of the shown rejected hypothesis, the marks of the measured distance, the frame of the sweep. */
    get rejection() { return store.get().rejection; },
    get marks() { return store.get().marks; },
    get moment() { return store.get().moment; },
    /** The hash that the address gets for what is shown, without "#". */
    get hash() { return hashOf(store.get(), app); },
    /** The files that the buttons save. */
    glb: () => [...glbOf(app.scene)],
    picture: () => pictureOf(app, 'light').toDataURL(),
    get frames() { return stage.frames; },
    /** Whether the picture and its labels show the state. */
    get drawn() { return stage.requested === 0; },
    /** As in gl/detail.js; its delay is 0 until a frame was measured. */
    get detail() { return stage.detail; },
    get rested() { return stage.isRested; },
    /** Back to how the page begins without a hash. */
    reset() {
      store.set(initialState(app.scene));
      viewpoint.go('home', false);
    },
    toggle: (key) => app.actions.toggle(key),
    select: (id) => app.actions.select(indexOf(id)),
    view: (name) => viewpoint.go(name, false),
    clickPoint: (id) => clickPoint(app, indexOf(id)),
    pixels: () => readPixels(app),
  };
}
