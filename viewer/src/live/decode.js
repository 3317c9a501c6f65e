// An update of a live scene as the server sends it (docs/formats.md, Live updates).
const HEADER = 36; // bytes
const VALUES = 4; // per point: x, y, z and the place of its object in the report, from 1; 0 for none

/** {report, size, positions, numbers, colors}: positions in metres, colours as bytes or null. */
export function decodeUpdate(buffer) {
  const view = new DataView(buffer);
  const magic = String.fromCharCode(...new Uint8Array(buffer, 0, 4));
  if (magic !== 'SYL1') throw new Error(`the server sent "${magic}" where an update starts with "SYL1"`);
  const [jsonLength, count, size, hasColors] = [4, 8, 12, 16].map((at) => view.getUint32(at, true));
  const corner = [20, 24, 28].map((at) => view.getFloat32(at, true));
  const step = view.getFloat32(32, true);
  const report = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, HEADER, jsonLength)));
  const begin = HEADER + jsonLength;
  const numberAt = [0, ...report.objects.map(({ number }) => number)];
  const positions = new Float32Array(3 * count);
  const numbers = new Uint32Array(count);
  for (let i = 0; i < count; ++i) {
    const at = begin + 2 * VALUES * i;
    for (let k = 0; k < 3; ++k) positions[3 * i + k] = corner[k] + step * view.getUint16(at + 2 * k, true);
    numbers[i] = numberAt[view.getUint16(at + 6, true)] ?? 0;
  }
  const colors = hasColors ? new Uint8Array(buffer, begin + 2 * VALUES * count, 3 * count) : null;
  return { report, size, positions, numbers, colors };
}
