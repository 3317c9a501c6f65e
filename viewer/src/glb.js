// All objects as one binary glTF 2.0 file: a node per object with its closed surface or, without one, its points. Vertices
// are in the world frame of the result, in metres; the root node turns them upright, as glTF has y up.
import { objectColor } from './palette.js';

const MAGIC = 0x46546c67; // "glTF"
const [JSON_CHUNK, BINARY_CHUNK] = [0x4e4f534a, 0x004e4942];
const [FLOAT, UINT32] = [5126, 5125];
const [POINTS, TRIANGLES] = [0, 4];
const [VERTICES, INDICES] = [34962, 34963];

// sRGB bytes as linear shares.
const linear = (color) => color.map((value) => (value / 255) ** 2.2);

class Buffers {
  constructor() {
    this.parts = [];
    this.length = 0;
    this.views = [];
    this.accessors = [];
  }

  /** The number of the accessor of an array. */
  add(array, type, componentType, target, bounds = {}) {
    this.views.push({ buffer: 0, byteOffset: this.length, byteLength: array.byteLength, target });
    const perItem = type === 'VEC3' ? 3 : 1;
    this.accessors.push({ bufferView: this.views.length - 1, componentType, count: array.length / perItem, type, ...bounds });
    this.parts.push(array);
    this.length += array.byteLength; // a multiple of 4
    return this.accessors.length - 1;
  }
}

function boundsOf(positions) {
  const [min, max] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  positions.forEach((value, i) => {
    min[i % 3] = Math.min(min[i % 3], value);
    max[i % 3] = Math.max(max[i % 3], value);
  });
  return { min, max };
}

function worldPositions(positions, frame) {
  const world = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) world.set(frame.toWorld([positions[i], positions[i + 1], positions[i + 2]]), i);
  return world;
}

// The points of an object as one array of coordinates.
function ownPoints({ points }, { positions }) {
  const own = new Float32Array(3 * points.length);
  points.forEach((point, i) => own.set(positions.subarray(3 * point, 3 * point + 3), 3 * i));
  return own;
}

function meshOf(object, scene, buffers) {
  const shape = object.closed ? object.closed.positions : ownPoints(object, scene.cloud);
  const positions = worldPositions(shape, scene.frame);
  const primitive = {
    attributes: { POSITION: buffers.add(positions, 'VEC3', FLOAT, VERTICES, boundsOf(positions)) },
    material: object.index, mode: object.closed ? TRIANGLES : POINTS,
  };
  if (object.closed) primitive.indices = buffers.add(object.closed.triangles, 'SCALAR', UINT32, INDICES);
  return { name: object.name, primitives: [primitive] };
}

const materialOf = ({ index, name }) => ({
  name, doubleSided: true,
  pbrMetallicRoughness: { baseColorFactor: [...linear(objectColor(index)), 1], metallicFactor: 0, roughnessFactor: 0.8 },
});

function documentOf(scene, buffers) {
  const objects = scene.objects.filter(({ points }) => points.length > 0);
  const meshes = objects.map((object) => meshOf(object, scene, buffers));
  const children = objects.map((_, i) => i + 1);
  return {
    asset: { version: '2.0', generator: 'SymScene' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: scene.title || 'scene', matrix: scene.frame.matrix, children },
      ...objects.map(({ name, score }, i) => ({ name, mesh: i, extras: { score } }))],
    meshes, materials: scene.objects.map(materialOf),
    accessors: buffers.accessors, bufferViews: buffers.views, buffers: [{ byteLength: buffers.length }],
  };
}

/** The bytes of the file; `scene` is in the display frame. */
export function glbOf(scene) {
  const buffers = new Buffers();
  const text = new TextEncoder().encode(JSON.stringify(documentOf(scene, buffers)));
  const padded = 4 * Math.ceil(text.length / 4);
  const bytes = new Uint8Array(12 + 8 + padded + 8 + buffers.length);
  const view = new DataView(bytes.buffer);
  [MAGIC, 2, bytes.length, padded, JSON_CHUNK].forEach((value, i) => view.setUint32(4 * i, value, true));
  bytes.fill(0x20, 20, 20 + padded).set(text, 20);
  [buffers.length, BINARY_CHUNK].forEach((value, i) => view.setUint32(20 + padded + 4 * i, value, true));
  let at = 28 + padded;
  for (const part of buffers.parts) {
    bytes.set(new Uint8Array(part.buffer, part.byteOffset, part.byteLength), at);
    at += part.byteLength;
  }
  return bytes;
}
