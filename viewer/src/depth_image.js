// Depth images as pictures: near is bright; where nothing was measured, there is a colour that no depth has.

const UNMEASURED = [42, 26, 62];

/** Red, green, blue and opacity per pixel of a depth image. */
export function depthPixels({ nearness }) {
  const pixels = new Uint8ClampedArray(4 * nearness.length);
  nearness.forEach((value, i) => pixels.set(value > 0 ? [value, value, value, 255] : [...UNMEASURED, 255], 4 * i));
  return pixels;
}

export function drawDepth(canvas, { width, height, ...depth }) {
  Object.assign(canvas, { width, height });
  if (width > 0 && height > 0) canvas.getContext('2d').putImageData(new ImageData(depthPixels(depth), width, height), 0, 0);
}
