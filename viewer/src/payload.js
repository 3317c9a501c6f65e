// Decodes the payload of the page into typed arrays. World frame, metres.
import { words } from './format.js';
import { trueColors } from './painting.js';
import { compareWithTruth } from './truth.js';

function decodeBytes(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// Typed arrays use the machine's byte order; every browser's is little endian, as the payload is.
export function decodeAs(Type, base64) {
  return base64 ? new Type(decodeBytes(base64).buffer) : new Type(0);
}

export function decodePositions({ encoding, data, min, step }) {
  if (encoding === 'f32') return decodeAs(Float32Array, data);
  const steps = decodeAs(Uint16Array, data);
  const positions = new Float32Array(steps.length);
  for (let i = 0; i < steps.length; ++i) positions[i] = min[i % 3] + steps[i] * step[i % 3];
  return positions;
}

function decodeNormals(base64) {
  const bytes = decodeAs(Int8Array, base64);
  const normals = new Float32Array(bytes.length);
  for (let i = 0; i < bytes.length; ++i) normals[i] = bytes[i] / 127;
  return normals;
}

function decodeCloud(cloud) {
  const positions = decodePositions(cloud.positions);
  return {
    count: positions.length / 3,
    positions,
    normals: decodeNormals(cloud.normals),
    colors: decodeAs(Uint8Array, cloud.colors),
  };
}

// Vertex indices: 0 is the next new vertex, n the vertex that was new n vertices ago. LEB128: seven
// bits per byte, lowest first; the eighth bit is set if more bytes follow.
function decodeTriangles({ count, data }) {
  const bytes = decodeBytes(data);
  const triangles = new Uint32Array(3 * count);
  let next = 0;
  for (let i = 0, at = 0; i < triangles.length; ++i) {
    let code = 0;
    for (let shift = 0; ; shift += 7) {
      code |= (bytes[at] & 0x7f) << shift;
      if (bytes[at++] < 0x80) break;
    }
    triangles[i] = code === 0 ? next++ : next - code;
  }
  return triangles;
}

export function decodeSurface({ positions, colors, triangles }) {
  return {
    positions: decodePositions(positions),
    colors: decodeAs(Uint8Array, colors),
    triangles: decodeTriangles(triangles),
  };
}

function decodeObject(object, index, noun) {
  const completed = decodeCloud(object.completed);
  const closed = object.closed ? decodeSurface(object.closed) : null;
  return {
    ...object,
    index,
    name: `${words(noun)} ${object.id}`,
    points: decodeAs(Uint32Array, object.points),
    completed,
    closed,
    effects: object.effects ?? [],
    pose: object.pose ?? null,
    hasCompletion: completed.count > 0 || closed !== null,
  };
}

const decodeRejection = (rejection) => ({
  ...rejection, points: decodeAs(Uint32Array, rejection.points ?? ''), effects: rejection.effects ?? [],
});

const decodeTruth = ({ name, points }) => ({ name, points: decodeAs(Uint32Array, points) });

export const decodeDepth = ({ width, height, data }) => ({ width, height, nearness: decodeAs(Uint8Array, data) });

// The ground truth with what was found of it.
function addTruth(scene) {
  if (!scene.truth) return scene;
  scene.compared = compareWithTruth(scene.truth, scene.objects);
  scene.cloud.trueColors = trueColors(scene.cloud.count, scene.truth, scene.compared);
  return scene;
}

const decodeFrame = ({ camera, depth }) => ({ camera, depth: decodeDepth(depth) });

export function decodePayload(payload) {
  const noun = payload.noun ?? 'object';
  return addTruth({
    ...payload,
    noun,
    cloud: decodeCloud(payload.cloud),
    objects: payload.objects.map((object, index) => decodeObject(object, index, noun)),
    warnings: payload.warnings ?? [],
    grasps: payload.grasps ?? null,
    views: payload.views ?? null,
    rejected: (payload.rejected ?? []).map(decodeRejection),
    truth: payload.truth ? payload.truth.map(decodeTruth) : null,
    sweep: payload.sweep ? payload.sweep.map(decodeFrame) : null,
    surface: payload.surface ? decodeSurface(payload.surface) : null,
    trajectory: payload.trajectory ? { ...payload.trajectory, path: decodePositions(payload.trajectory.path) } : null,
  });
}
