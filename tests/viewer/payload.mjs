// Writes payloads as the C++ side does, and puts them into the built page.
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
    centroid: object.centroid,
    completed: encodeCloud(object.completed ?? { positions: [] }),
  };
}

export function encodeScene({ title = '', note = '', up = [0, 0, 1], table = null, cloud, objects = [], ...rest }) {
  return {
    version: 1, title, note, up, table,
    cloud: encodeCloud(cloud),
    objects: objects.map(encodeObject),
    timings: rest.timings ?? [], funnel: rest.funnel ?? [], rejected: rest.rejected ?? [],
  };
}

const escapeHtml = (text) => text.replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);

export async function writePage(path, payload) {
  const template = await readFile(new URL('../../viewer/dist/page.html', import.meta.url), 'utf8');
  const json = JSON.stringify(payload).replace(/</g, '\\u003c');
  await writeFile(path, template
    .replace('@@SYMSCENE_TITLE@@', () => escapeHtml(payload.title))
    .replace('"@@SYMSCENE_PAYLOAD@@"', () => json));
}
