// Writes payloads like the C++ code, and inserts them into the built page.
import { readFile, writeFile } from 'node:fs/promises';

const base64 = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString('base64');

export function encodeCloud({ positions, normals = [], colors = [] }) {
  const flat = Float32Array.from(positions.flat());
  const bytes = Int8Array.from(normals.flat(), (value) => Math.round(127 * value));
  return {
    positions: { encoding: 'f32', data: base64(flat) },
    normals: base64(bytes),
    colors: base64(Uint8Array.from(colors.flat())),
  };
}

export function encodeObject(object, id) {
  return {
    id,
    score: object.score,
    points: base64(Uint32Array.from(object.points)),
    rotational: object.rotational ?? [],
    reflectional: object.reflectional ?? [],
    class: object.class ?? null,
    centroid: object.centroid,
    effects: object.effects ?? [],
    pose: object.pose ?? null,
    volume: object.volume ?? null,
    closed: object.closed ? encodeSurface(object.closed) : null,
    completed: encodeCloud(object.completed ?? { positions: [] }),
  };
}

const encodePoints = (points) => base64(Uint32Array.from(points));

const encodeRejection = (rejection) => ({ ...rejection, points: encodePoints(rejection.points ?? []), effects: rejection.effects ?? [] });

/** Corners as how many new vertices ago theirs came up, 0 for a new one, seven bits a byte. */
function encodeTriangles(triangles) {
  const names = new Map();
  const bytes = triangles.flat().flatMap((corner) => {
    const isNew = !names.has(corner);
    const next = names.size;
    if (isNew) names.set(corner, next);
    const code = [];
    let rest = isNew ? 0 : next - names.get(corner);
    for (; rest >= 0x80; rest >>= 7) code.push((rest & 0x7f) | 0x80);
    return [...code, rest];
  });
  return { order: [...names.keys()], triangles: { count: triangles.length, data: base64(Uint8Array.from(bytes)) } };
}

export function encodeSurface({ positions, colors, triangles }) {
  const { order, triangles: encoded } = encodeTriangles(triangles);
  const cloud = encodeCloud({ positions: order.map((i) => positions[i]), colors: colors.length ? order.map((i) => colors[i]) : [] });
  return { positions: cloud.positions, colors: cloud.colors, triangles: encoded };
}

export const encodeTrajectory = ({ path, cameras }) =>
  ({ frames: path.length, path: encodeCloud({ positions: path }).positions, cameras });

export function encodeScene({ title = '', note = '', up = [0, 0, 1], table = null, cloud, objects = [], ...rest }) {
  return {
    version: 1, title, note, up, table,
    cloud: encodeCloud(cloud),
    objects: objects.map(encodeObject),
    surface: rest.surface ? encodeSurface(rest.surface) : null,
    trajectory: rest.trajectory ? encodeTrajectory(rest.trajectory) : null,
    grasps: rest.grasps ?? null,
    views: rest.views ?? null,
    timings: rest.timings ?? [], funnel: rest.funnel ?? [], rejected: (rest.rejected ?? []).map(encodeRejection),
    truth: rest.truth ? rest.truth.map(({ name, points }) => ({ name, points: encodePoints(points) })) : null,
    sweep: rest.sweep ? rest.sweep.map(({ camera, depth }) => ({ camera, depth: { ...depth, data: base64(depth.data) } })) : null,
    warnings: rest.warnings ?? [],
  };
}

/** A run: `poses[moment][solid]` are {position, rotation (x, y, z, w)}. All moments of all solids are kept. */
export function encodeRun({ title, times, solids, poses, beliefs, events, left }) {
  const track = (k) => ({
    moments: base64(Uint32Array.from(times, (_, i) => i)),
    positions: encodeCloud({ positions: poses.map((all) => all[k].position) }).positions,
    rotations: base64(Int16Array.from(poses.flatMap((all) => all[k].rotation), (value) => Math.round(32767 * value))),
  });
  const surface = (mesh) => mesh && encodeSurface({ colors: [], ...mesh });
  return {
    version: 1, title, events, left,
    times: base64(Float64Array.from(times)),
    solids: solids.map(({ name, kind, mesh }, k) => ({ name, kind, surface: surface(mesh), track: track(k) })),
    beliefs: beliefs.map(({ time, objects }) => ({ time, objects: objects.map(({ name, label, mesh }) => ({ name, label, surface: surface(mesh) })) })),
  };
}

const escapeHtml = (text) => text.replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);

export async function writePage(path, payload, page = 'page.html') {
  const template = await readFile(new URL(`../../viewer/dist/${page}`, import.meta.url), 'utf8');
  const json = JSON.stringify(payload).replace(/</g, '\\u003c');
  await writeFile(path, template
    .replace('@@SYMSCENE_TITLE@@', () => escapeHtml(payload.title))
    .replace('"@@SYMSCENE_PAYLOAD@@"', () => json));
}
