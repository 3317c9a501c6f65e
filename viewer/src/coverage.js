// Points of the cloud that lie on the reconstructed surface. The surface's vertices take their
// owners from them, and they need not be drawn as points.

export const NO_POINT = -1;
const REACH_OF_SPACING = 1.6; // from a point to the surface that shows it
const LEAST_AGREEMENT = 0.3; // cosine between the normals of a vertex and of the point that it takes

// Points in the cells of a grid; the map's keys are made of the cell's coordinates.
class Grid {
  constructor(positions, size) {
    this.size = size;
    this.cells = new Map();
    for (let i = 0; i < positions.length; i += 3) {
      const key = this.key(...[0, 1, 2].map((axis) => this.index(positions[i + axis])));
      const cell = this.cells.get(key);
      if (cell) cell.push(i / 3);
      else this.cells.set(key, [i / 3]);
    }
  }

  index(coordinate) { return Math.floor(coordinate / this.size); }

  // Up to 2^16 cells along an axis are told apart; points of cells that share a key are too far away.
  key(x, y, z) { return ((x & 0xffff) * 0x10000 + (y & 0xffff)) * 0x10000 + (z & 0xffff); }

  /** Calls visit(point) for the points of the cells around. */
  around(x, y, z, visit) {
    const [cx, cy, cz] = [this.index(x), this.index(y), this.index(z)];
    for (let i = cx - 1; i <= cx + 1; ++i) {
      for (let j = cy - 1; j <= cy + 1; ++j) {
        for (let k = cz - 1; k <= cz + 1; ++k) this.cells.get(this.key(i, j, k))?.forEach(visit);
      }
    }
  }
}

/**
 * For every vertex the nearest point within `spacing` that faces the same way, or NO_POINT; and for
 * every point whether a vertex is near. Vertices below `lowest`, in the table, take no point.
 */
export function coverage(surface, normals, cloud, spacing, lowest = -Infinity) {
  const reach = REACH_OF_SPACING * spacing;
  const { positions: p } = surface;
  const { positions: q, normals: m } = cloud;
  const grid = new Grid(q, reach);
  const nearest = new Int32Array(p.length / 3).fill(NO_POINT);
  const covered = new Uint8Array(cloud.count);
  const agree = (v, i) => m.length === 0 ||
    normals[v] * m[i] + normals[v + 1] * m[i + 1] + normals[v + 2] * m[i + 2] > LEAST_AGREEMENT;
  for (let v = 0; v < p.length; v += 3) {
    let best = p[v + 1] < lowest ? 0 : spacing * spacing;
    grid.around(p[v], p[v + 1], p[v + 2], (point) => {
      const i = 3 * point;
      const d = (p[v] - q[i]) ** 2 + (p[v + 1] - q[i + 1]) ** 2 + (p[v + 2] - q[i + 2]) ** 2;
      if (d > reach * reach) return;
      covered[point] = 1;
      if (d >= best || !agree(v, i)) return;
      best = d;
      nearest[v / 3] = point;
    });
  }
  return { nearest, covered };
}
