// Normals of a mesh that is smooth except at sharp edges.

const CREASE = 0.7; // edges sharper than this are drawn sharp [rad]

/** Per triangle its normal, as long as twice its area. */
function faceNormals(positions, triangles) {
  const normals = new Float32Array(triangles.length);
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
    const [ux, uy, uz] = [positions[b] - positions[a], positions[b + 1] - positions[a + 1], positions[b + 2] - positions[a + 2]];
    const [vx, vy, vz] = [positions[c] - positions[a], positions[c + 1] - positions[a + 1], positions[c + 2] - positions[a + 2]];
    normals[i] = uy * vz - uz * vy;
    normals[i + 1] = uz * vx - ux * vz;
    normals[i + 2] = ux * vy - uy * vx;
  }
  return normals;
}

/** The triangles at each vertex: those of vertex v are faces[starts[v]] to faces[starts[v + 1] - 1]. */
function facesOfVertices(triangles, vertices) {
  const starts = new Uint32Array(vertices + 1);
  for (const vertex of triangles) starts[vertex + 1] += 1;
  for (let v = 0; v < vertices; ++v) starts[v + 1] += starts[v];
  const next = starts.slice();
  const faces = new Uint32Array(triangles.length);
  triangles.forEach((vertex, corner) => { faces[next[vertex]++] = 3 * Math.floor(corner / 3); });
  return { starts, faces };
}

/** Positions and normals of three corners per triangle. A normal is the mean of those around that are not beyond a crease. */
export function creasedCorners({ positions, triangles }) {
  const flat = faceNormals(positions, triangles);
  const { starts, faces } = facesOfVertices(triangles, positions.length / 3);
  const corners = new Float32Array(3 * triangles.length);
  const normals = new Float32Array(3 * triangles.length);
  const lengths = Float32Array.from({ length: triangles.length / 3 }, (_, t) => Math.hypot(flat[3 * t], flat[3 * t + 1], flat[3 * t + 2]));
  const least = Math.cos(CREASE);
  for (let i = 0; i < triangles.length; ++i) {
    const [own, vertex] = [3 * Math.floor(i / 3), triangles[i]];
    let [x, y, z] = [0, 0, 0];
    for (let k = starts[vertex]; k < starts[vertex + 1]; ++k) {
      const f = faces[k];
      const along = flat[f] * flat[own] + flat[f + 1] * flat[own + 1] + flat[f + 2] * flat[own + 2];
      if (along < least * lengths[f / 3] * lengths[own / 3]) continue;
      x += flat[f]; y += flat[f + 1]; z += flat[f + 2];
    }
    const size = Math.hypot(x, y, z) || 1;
    for (let k = 0; k < 3; ++k) corners[3 * i + k] = positions[3 * vertex + k];
    normals[3 * i] = x / size;
    normals[3 * i + 1] = y / size;
    normals[3 * i + 2] = z / size;
  }
  return { corners, normals };
}
