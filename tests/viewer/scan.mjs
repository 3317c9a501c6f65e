// The reconstruction of the synthetic tabletop: a mesh of the table and the objects, and the path of
// the camera.

const GRAIN = 0.01;

class Mesh {
  positions = [];
  colors = [];
  triangles = [];

  /** A sheet of rows × columns quadrilaterals; at(row, column) is its vertex. */
  add(rows, columns, at, color) {
    const first = this.positions.length;
    for (let i = 0; i <= rows; ++i) {
      for (let k = 0; k <= columns; ++k) {
        this.positions.push(at(i, k));
        this.colors.push(color);
      }
    }
    for (let i = 0; i < rows; ++i) {
      for (let k = 0; k < columns; ++k) {
        const a = first + i * (columns + 1) + k;
        this.triangles.push([a, a + columns + 2, a + 1], [a, a + columns + 1, a + columns + 2]);
      }
    }
  }
}

function addRevolution(mesh, { at: [x, y], profile }) {
  const around = 48;
  for (let k = 0; k + 1 < profile.length; ++k) {
    const [[r0, z0], [r1, z1]] = [profile[k], profile[k + 1]];
    const rows = Math.max(1, Math.round(Math.hypot(r1 - r0, z1 - z0) / GRAIN));
    mesh.add(rows, around, (row, column) => {
      const t = row / rows;
      const a = (-2 * Math.PI * column) / around;
      const r = r0 + t * (r1 - r0);
      return [x + r * Math.cos(a), y + r * Math.sin(a), z0 + t * (z1 - z0)];
    }, [150, 150, 160]);
  }
}

function addBox(mesh, { at: [x, y], size, turn }) {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  for (let axis = 0; axis < 3; ++axis) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    const [rows, columns] = [u, v].map((side) => Math.round(size[side] / GRAIN));
    for (const side of [-1, 1]) {
      mesh.add(rows, columns, (row, column) => {
        const q = [0, 0, 0];
        q[axis] = (side * size[axis]) / 2;
        q[u] = (row / rows - 0.5) * size[u];
        q[v] = side * (column / columns - 0.5) * size[v];
        return [c * q[0] - s * q[1] + x, s * q[0] + c * q[1] + y, q[2] + size[2] / 2];
      }, [170, 150, 130]);
    }
  }
}

export function scannedSurface(solids) {
  const mesh = new Mesh();
  mesh.add(50, 80, (row, column) => [0.02 * column - 0.8, 0.5 - 0.02 * row, 0], [182, 160, 132]);
  for (const solid of solids) (solid.size ? addBox : addRevolution)(mesh, solid);
  return mesh;
}

/** The closed surface of a solid: observed (white) on the side of the camera, inferred (black) behind. */
export function closedSurface(solid) {
  const mesh = new Mesh();
  (solid.size ? addBox : addRevolution)(mesh, solid);
  mesh.colors = mesh.positions.map(([, y]) => (y < solid.at[1] ? [255, 255, 255] : [0, 0, 0]));
  return mesh;
}

/** A quarter of a turn about the table, looking at its middle. */
export function sweep() {
  const path = Array.from({ length: 60 }, (_, i) => {
    const a = -2.3 + (1.5 * i) / 59;
    return [Math.cos(a), Math.sin(a), 0.6];
  });
  const cameras = path.filter((_, i) => i % 10 === 0).map((position) => {
    const length = Math.hypot(...position);
    const forward = position.map((value) => -value / length);
    const flat = Math.hypot(forward[0], forward[1]);
    const right = [forward[1] / flat, -forward[0] / flat, 0];
    const down = [
      forward[1] * right[2] - forward[2] * right[1],
      forward[2] * right[0] - forward[0] * right[2],
      forward[0] * right[1] - forward[1] * right[0],
    ];
    return { position, right, down, forward };
  });
  return { path, cameras };
}
