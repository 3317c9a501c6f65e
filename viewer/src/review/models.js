// The models of the payload in the frame of the view: about the origin, of one size, z up.
import { decodePositions, decodeSurface } from '../payload.js';
import { objectColor } from '../palette.js';

export const SIZE = 0.25; // of every model's diagonal in the view

function box(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  return { low, high };
}

const upright = ([x, y, z]) => [x, z, -y];

/** Maps points of the model's file into the view. */
function placement(positions) {
  const { low, high } = box(positions);
  const middle = low.map((value, k) => (value + high[k]) / 2);
  const size = SIZE / (Math.hypot(...low.map((value, k) => high[k] - value)) || 1);
  return (p) => upright(p.map((value, k) => size * (value - middle[k])));
}

function placed(positions, place) {
  const result = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    result.set(place([positions[i], positions[i + 1], positions[i + 2]]), i);
  }
  return result;
}

export function nameOf({ kind, order }) {
  if (kind === 'sphere') return 'Sphere';
  if (kind === 'plane') return 'Mirror plane';
  return order === 'continuous' ? 'Axis, any angle' : `Axis, ${order}-fold`;
}

export function tagOf({ kind, order }) {
  if (kind !== 'axis') return '';
  return order === 'continuous' ? '∞' : `${order}-fold`;
}

function sample(positions, limit = 1500) {
  const step = 3 * Math.max(1, Math.floor(positions.length / 3 / limit));
  const points = [];
  for (let i = 0; i + 2 < positions.length; i += step) points.push([...positions.slice(i, i + 3)]);
  return points;
}

export function decodeModel(model) {
  const surface = model.surface && decodeSurface(model.surface);
  const raw = surface ? surface.positions : decodePositions(model.points);
  const place = placement(raw);
  const positions = placed(raw, place);
  return {
    ...model,
    positions,
    triangles: surface?.triangles ?? null,
    outline: sample(positions),
    shown: model.symmetries.map((symmetry, index) => ({
      kind: symmetry.kind,
      order: symmetry.order,
      point: place(symmetry.point),
      direction: upright(symmetry.direction),
      color: objectColor(index),
    })),
  };
}
