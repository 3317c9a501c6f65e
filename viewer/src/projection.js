// From the display frame to CSS pixels of the canvas.

/** The camera's view-projection as sixteen numbers, column major. */
export function viewProjection(camera) {
  camera.updateMatrixWorld();
  return camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).elements;
}

/** Maps a point to {x, y, depth}, or to null behind the camera. */
export function projector(camera, width, height) {
  const m = viewProjection(camera);
  return (x, y, z) => {
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0) return null;
    return {
      x: (((m[0] * x + m[4] * y + m[8] * z + m[12]) / w) * 0.5 + 0.5) * width,
      y: (0.5 - ((m[1] * x + m[5] * y + m[9] * z + m[13]) / w) * 0.5) * height,
      depth: w,
    };
  };
}
