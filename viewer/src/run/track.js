// The way of a solid: poses at some moments, interpolated between them.
import { decodeAs, decodePositions } from '../payload.js';

export function decodeTrack({ moments, positions, rotations }, times) {
  return {
    times: Float64Array.from(decodeAs(Uint32Array, moments), (moment) => times[moment]),
    positions: decodePositions(positions),
    rotations: Float32Array.from(decodeAs(Int16Array, rotations), (value) => value / 32767),
  };
}

/** The index of the last of `times` that is not after `time`; −1 if all are. `times` never fall. */
export function lastNotAfter(times, time) {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Spherical interpolation between unit quaternions (Shoemake 1985), the shorter way. */
export function slerp(a, b, t) {
  let cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const sign = cosine < 0 ? -1 : 1;
  cosine = Math.min(1, Math.abs(cosine));
  const angle = Math.acos(cosine);
  const small = angle < 1e-4;
  const from = small ? 1 - t : Math.sin((1 - t) * angle) / Math.sin(angle);
  const to = sign * (small ? t : Math.sin(t * angle) / Math.sin(angle));
  const mixed = a.map((value, i) => from * value + to * b[i]);
  const size = Math.hypot(...mixed) || 1;
  return mixed.map((value) => value / size);
}

/** Position and rotation (x, y, z, w) at a time; before the first and after the last moment theirs. */
export function poseAt({ times, positions, rotations }, time) {
  const before = Math.max(0, lastNotAfter(times, time));
  const after = Math.min(before + 1, times.length - 1);
  const span = times[after] - times[before];
  const t = span > 0 ? Math.min(1, Math.max(0, (time - times[before]) / span)) : 0;
  const position = [0, 1, 2].map((k) => positions[3 * before + k] + t * (positions[3 * after + k] - positions[3 * before + k]));
  const rotation = (i) => Array.from(rotations.subarray(4 * i, 4 * i + 4));
  return { position, rotation: slerp(rotation(before), rotation(after), t) };
}
