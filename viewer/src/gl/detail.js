// How finely a page draws, by what a picture costs. Without a graphics card, fewer pixels keep movement smooth.

const MOTION_COST = 40; // longest time per frame during movement [ms]
const REST_COST = 400; // longest time of a still picture with four samples per pixel; the page does not react meanwhile [ms]
const COARSEST = 0.4; // pixels of a moving picture per pixel of the screen, along each side

/** The scale of the first frames, of which the second is measured: a still picture follows. */
export const MEASURED_SCALE = 0.5;

// Reading a pixel waits for it.
const finish = (gl) => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));

/** Milliseconds from the call of `draw` until the picture is drawn, without what was asked for before. */
export function measured(gl, draw) {
  finish(gl);
  const begin = performance.now();
  draw();
  finish(gl);
  return performance.now() - begin;
}

/** Scale during movement, and samples along each side of a pixel at rest, where a frame at MEASURED_SCALE takes `cost` ms. */
export function detailFor(cost) {
  const whole = cost / MEASURED_SCALE ** 2;
  return {
    motionScale: Math.min(1, Math.max(COARSEST, Math.sqrt(MOTION_COST / whole))),
    restSamples: 4 * whole > REST_COST ? 1 : 2,
  };
}
