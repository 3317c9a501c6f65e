// Meshes of the solids of a recorded run, in metres.

export const add = (a, b) => a.map((value, i) => value + b[i]);
export const subtract = (a, b) => a.map((value, i) => value - b[i]);
export const moved = (mesh, shift) => ({ ...mesh, positions: mesh.positions.map((p) => add(p, shift)) });

export function turnZ(mesh, yaw) {
  const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
  return { ...mesh, positions: mesh.positions.map(([x, y, z]) => [c * x - s * y, s * x + c * y, z]) };
}

const FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/** A box that stands on z = 0. */
export function box([x, y, z]) {
  const positions = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1 ? x / 2 : -x / 2, i & 2 ? y / 2 : -y / 2, i & 4 ? z : 0]);
  return { positions, triangles: FACES.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]) };
}

/** A closed surface of revolution about z: `profile` are (radius, height) from below to above. */
function revolution(profile, around = 32) {
  const positions = profile.flatMap(([r, z]) => Array.from({ length: around }, (_, i) => {
    const a = (2 * Math.PI * i) / around;
    return [r * Math.cos(a), r * Math.sin(a), z];
  }));
  const triangles = [];
  for (let row = 0; row + 1 < profile.length; ++row) {
    for (let i = 0; i < around; ++i) {
      const [a, b] = [row * around + i, row * around + ((i + 1) % around)];
      triangles.push([a, b, b + around], [a, b + around, a + around]);
    }
  }
  return { positions, triangles };
}

export const cylinder = (radius, height) => revolution([[0, 0], [radius, 0], [radius, height], [0, height]]);

/** A capsule about the segment from the origin to (0, 0, length). */
export function capsule(radius, length) {
  const cap = (from, z) => Array.from({ length: 9 }, (_, i) => {
    const a = from + (i * Math.PI) / 16;
    return [radius * Math.cos(a), z + radius * Math.sin(a)];
  });
  return revolution([...cap(-Math.PI / 2, 0), ...cap(0, length)]);
}
