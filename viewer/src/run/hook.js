// window.symscene: the interface for tests and for scripts that take pictures.

import { initialState } from './state.js';

// Per drawn view the share of pixels that are not empty, and a hash of all.
function readPixels(view) {
  view.drawNow();
  const gl = view.renderer.getContext();
  const ratio = view.renderer.getPixelRatio();
  return view.parts.map(({ side, left, width }) => {
    const [w, h] = [Math.floor(width * ratio), gl.drawingBufferHeight];
    const bytes = new Uint8Array(4 * w * h);
    gl.readPixels(Math.round(left * ratio), 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let [filled, hash] = [0, 0];
    for (let i = 0; i < bytes.length; i += 4) {
      if (bytes[i + 3] > 200) filled += 1;
      hash = (Math.imul(hash, 31) + bytes[i] + 7 * bytes[i + 1] + 13 * bytes[i + 2]) | 0;
    }
    return { side, filled: filled / (w * h), hash };
  });
}

export function createHook(recording, { view, store, actions, currentEvent, recorder }) {
  window.symscene = {
    ready: new Promise((resolve) => {
      const check = () => (view.frames >= 2 && view.detail.restDelay > 0 ? resolve(true) : requestAnimationFrame(check));
      check();
      view.invalidate();
    }),
    get time() { return store.get().time; },
    get playing() { return store.get().playing; },
    get speed() { return store.get().speed; },
    get views() { return store.get().views; },
    get event() { return currentEvent(store.get().time); },
    get belief() { return recording.beliefAt(store.get().time); },
    get recording() { return recorder.media !== null; },
    get grasp() { return store.get().grasp; },
    get candidate() { return store.get().candidate; },
    get map() { return store.get().map; },
    get frames() { return view.frames; },
    /** Whether the picture and its tags show the state. */
    get drawn() { return view.requested === 0; },
    /** As in gl/detail.js; its delay is 0 until a frame was measured. */
    get detail() { return view.detail; },
    get rested() { return view.isRested; },
    /** Back to how the page begins without a hash. */
    reset() {
      store.set(initialState(recording));
      view.viewpoint.go('home', false);
    },
    get tags() { return view.tags.shown.map(({ text }) => text); },
    seek: (time) => actions.seek(time),
    view: (name) => view.viewpoint.go(name, false),
    pixels: () => readPixels(view),
  };
}
