// How finely a page draws, by what a picture costs. Without a graphics card, fewer pixels keep movement smooth.

const MOTION_COST = 40; // longest time per frame during movement [ms]
const REST_COST = 400; // longest time of a still picture with four samples per pixel; the page does not react meanwhile [ms]
const REST_DELAY = 140; // shortest time without movement before the still picture is drawn [ms]
const LONGEST_REST_DELAY = 800; // [ms]
const COARSEST = 0.4; // pixels of a moving picture per pixel of the screen, along each side

/** Of the first frames, of which the second is measured. */
const MEASURED_SCALE = 0.5;

/** Before a frame was measured: the still picture follows at once. */
export const FIRST_DETAIL = { motionScale: MEASURED_SCALE, restSamples: 2, restDelay: 0 };

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

/**
 * Scale during movement, samples along each side of a pixel at rest, and the delay before that [ms], where a frame at
 * MEASURED_SCALE takes `cost` ms. A still picture that takes long waits longer, because it would hold up the next movement.
 */
export function detailFor(cost) {
  const whole = cost / MEASURED_SCALE ** 2;
  return {
    motionScale: Math.min(1, Math.max(COARSEST, Math.sqrt(MOTION_COST / whole))),
    restSamples: 4 * whole > REST_COST ? 1 : 2,
    restDelay: Math.min(LONGEST_REST_DELAY, Math.max(REST_DELAY, whole)),
  };
}
