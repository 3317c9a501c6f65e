// Symmetries as motions of the points of a model, x' = A x + b.
import { add, scale, subtract } from '../vector.js';

const FREE_TURN = (8 * Math.PI) / 15; // no multiple of a turn of low order

/** The columns of a turn about a unit vector, by Rodrigues' formula. */
function turnColumns([x, y, z], angle) {
  const [c, s, t] = [Math.cos(angle), Math.sin(angle), 1 - Math.cos(angle)];
  return [
    [t * x * x + c, t * x * y + s * z, t * x * z - s * y],
    [t * x * y - s * z, t * y * y + c, t * y * z + s * x],
    [t * x * z + s * y, t * y * z - s * x, t * z * z + c],
  ];
}

function reflectionColumns(n) {
  return [0, 1, 2].map((k) => [0, 1, 2].map((i) => (i === k ? 1 : 0) - 2 * n[i] * n[k]));
}

function columnsOf({ kind, order, direction }) {
  if (kind === 'plane') return reflectionColumns(direction);
  return turnColumns(direction, typeof order === 'number' ? (2 * Math.PI) / order : FREE_TURN);
}

const times = (columns, p) => columns.reduce((sum, column, k) => add(sum, scale(column, p[k])), [0, 0, 0]);

/** The columns of A, and b. */
export function motionOf(symmetry) {
  const columns = columnsOf(symmetry);
  return { columns, shift: subtract(symmetry.point, times(columns, symmetry.point)) };
}

export const moved = ({ columns, shift }, p) => add(times(columns, p), shift);
