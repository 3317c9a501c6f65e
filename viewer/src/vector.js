// Three-vectors as plain arrays, for geometry outside three.js.

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const normalize = (a) => scale(a, 1 / (length(a) || 1));
export const isVector = (a) => Array.isArray(a) && a.length === 3 && a.every(Number.isFinite);

/** The component of `a` that is perpendicular to the unit vector `n`. */
export const reject = (a, n) => subtract(a, scale(n, dot(a, n)));

/** Two unit vectors that span the plane with unit normal `n`; the second follows `hint`. */
export function planeBasis(n, hint) {
  let v = reject(hint, n);
  if (length(v) < 0.2) v = reject(Math.abs(n[0]) < 0.8 ? [1, 0, 0] : [0, 0, 1], n);
  v = normalize(v);
  return [cross(v, n), v];
}

/** The value below which `fraction` of `values` lie. Sorts a copy. */
export function quantile(values, fraction) {
  if (values.length === 0) return 0;
  const sorted = Float32Array.from(values).sort();
  return sorted[Math.min(sorted.length - 1, Math.floor(fraction * sorted.length))];
}
