// Decodes the payload of a run. Frame of the table: z up, metres and seconds.
import { decodeAs, decodeSurface } from '../payload.js';
import { decodeExploration } from './explore.js';
import { decodePlan } from './plan.js';
import { decodeTrack, lastNotAfter, poseAt } from './track.js';

/** Middle and diagonal of the box around a surface; null without one. */
function extentOf(surface) {
  if (!surface) return null;
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  const { positions } = surface;
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const middle = low.map((value, k) => (value + high[k]) / 2);
  return { low, high, middle, diagonal: Math.hypot(...low.map((value, k) => high[k] - value)) };
}

function decodeSolid(solid, times, index) {
  const track = decodeTrack(solid.track, times);
  // Of a run that never began, nothing is known to be anywhere.
  const surface = solid.surface && track.times.length > 0 ? decodeSurface(solid.surface) : null;
  return { ...solid, index, surface, extent: extentOf(surface), track };
}

/** A point of a solid's own frame in that of the table. */
export function placed({ position, rotation: [x, y, z, w] }, [px, py, pz]) {
  // v + 2 w (u × v) + 2 u × (u × v), for the quaternion (u, w).
  const [cx, cy, cz] = [y * pz - z * py, z * px - x * pz, x * py - y * px];
  return [
    position[0] + px + 2 * (w * cx + y * cz - z * cy),
    position[1] + py + 2 * (w * cy + z * cx - x * cz),
    position[2] + pz + 2 * (w * cz + x * cy - y * cx),
  ];
}

/** The true object whose middle is nearest to a believed one and within half of its size; null if none is. */
export function counterpartOf(extent, objects, time) {
  if (!extent) return null;
  const near = objects.filter((object) => object.extent).map((object) => {
    const middle = placed(poseAt(object.track, time), object.extent.middle);
    return { object, distance: Math.hypot(...middle.map((value, k) => value - extent.middle[k])) };
  }).filter(({ object, distance }) => distance <= object.extent.diagonal / 2);
  near.sort((a, b) => a.distance - b.distance);
  return near[0]?.object ?? null;
}

export function decodeRecording(payload) {
  const times = decodeAs(Float64Array, payload.times);
  const solids = payload.solids.map((solid, index) => decodeSolid(solid, times, index));
  const objects = solids.filter(({ kind }) => kind === 'object');
  // Surfaces are decoded when their belief is first shown: a long run has many.
  const decoded = new Map();
  const decodeBelief = (index) => payload.beliefs[index].objects.map((object) => {
    const surface = object.surface && decodeSurface(object.surface);
    const extent = extentOf(surface);
    return { ...object, surface, extent, counterpart: counterpartOf(extent, objects, payload.beliefs[index].time) };
  });
  const beliefTimes = payload.beliefs.map(({ time }) => time);
  return {
    title: payload.title,
    begin: times[0] ?? 0,
    end: times[times.length - 1] ?? 0,
    solids,
    objects,
    events: payload.events,
    left: payload.left,
    plan: decodePlan(payload.plan),
    exploration: decodeExploration(payload.exploration),
    beliefTimes,
    /** The index of the belief at a time; −1 before the first. */
    beliefAt: (time) => lastNotAfter(beliefTimes, time),
    believed(index) {
      if (!decoded.has(index)) decoded.set(index, decodeBelief(index));
      return decoded.get(index);
    },
  };
}
