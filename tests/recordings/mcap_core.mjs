// MCAP files of the command against npm's @mcap/core and Foxglove's schemas: node --test mcap_core.mjs, after `npm ci` in viewer/.
// SYMSCENE_COMMAND names the command.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtemp, mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

const require = createRequire(new URL('../../viewer/package.json', import.meta.url));
const { McapIndexedReader, McapWriter, TempBuffer } = require('@mcap/core');
const schemas = Object.values(require('@foxglove/schemas/jsonschema'));

const WIDTH = 8, HEIGHT = 6, FRAMES = 3;
const SECOND = 1_000_000_000n;

let folder;
before(async () => { folder = await mkdtemp(join(tmpdir(), 'symscene-mcap-')); });
after(() => rm(folder, { recursive: true }));

const run = (...args) => execFileSync(process.env.SYMSCENE_COMMAND, args, { encoding: 'utf8' });

// The fields of a message in CDR, little endian.
class Cdr {
  bytes = [];
  number(size, write) {
    while (this.bytes.length % size) this.bytes.push(0);
    const view = new DataView(new ArrayBuffer(size));
    write(view);
    this.bytes.push(...new Uint8Array(view.buffer));
    return this;
  }
  u8(value) { this.bytes.push(value); return this; }
  u32(value) { return this.number(4, (view) => view.setUint32(0, value, true)); }
  f64(value) { return this.number(8, (view) => view.setFloat64(0, value, true)); }
  text(value) { this.u32(value.length + 1); this.bytes.push(...Buffer.from(`${value}\0`)); return this; }
  data(bytes) { this.u32(bytes.length); this.bytes.push(...bytes); return this; }
  header(frame) { return this.u32(100 + frame).u32(0).text('camera'); }
  finish() { return Uint8Array.from([0, 1, 0, 0, ...this.bytes]); }
}

const pixels = (frame) => new Uint8Array(Uint16Array.from({ length: WIDTH * HEIGHT }, (_, k) => 500 + 10 * frame + k).buffer);

const depthImage = (frame) => new Cdr().header(frame).u32(HEIGHT).u32(WIDTH).text('16UC1').u8(0).u32(2 * WIDTH).data(pixels(frame)).finish();

function cameraInfo(frame) {
  const message = new Cdr().header(frame).u32(HEIGHT).u32(WIDTH).text('plumb_bob').u32(0);
  for (const k of [10, 0, 3.5, 0, 11, 2.5, 0, 0, 1]) message.f64(k);
  for (let i = 0; i < 21; ++i) message.f64(0);
  return message.finish();
}

// A recording as a robot makes it, written by @mcap/core.
async function recording() {
  const buffer = new TempBuffer();
  const writer = new McapWriter({ writable: buffer, chunkSize: 200 });
  await writer.start({ profile: 'ros2', library: 'test' });
  const channel = async (topic, name) => writer.registerChannel({
    topic, messageEncoding: 'cdr', metadata: new Map(),
    schemaId: await writer.registerSchema({ name, encoding: 'ros2msg', data: new Uint8Array() }),
  });
  const depth = await channel('/camera/depth/image_raw', 'sensor_msgs/msg/Image');
  const info = await channel('/camera/depth/camera_info', 'sensor_msgs/msg/CameraInfo');
  for (let frame = 0; frame < FRAMES; ++frame) {
    const logTime = BigInt(100 + frame) * SECOND;
    for (const [channelId, data] of [[depth, depthImage(frame)], [info, cameraInfo(frame)]]) {
      await writer.addMessage({ channelId, sequence: frame, logTime, publishTime: logTime, data });
    }
  }
  await writer.end();
  return buffer.get();
}

// The messages of a file by topic, with what @mcap/core checks: summary, indices and checksums.
async function messagesOf(file) {
  const bytes = await readFile(file);
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
  };
  const reader = await McapIndexedReader.Initialize({ readable });
  const messages = {};
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(message.channelId);
    (messages[channel.topic] ??= []).push({ ...message, schema: reader.schemasById.get(channel.schemaId) });
  }
  return { messages, statistics: reader.statistics };
}

test('what @mcap/core writes is read, and written so that it reads the same pixels', async () => {
  const first = join(folder, 'first.mcap'), second = join(folder, 'second.mcap');
  await writeFile(first, await recording());
  const facts = JSON.parse(run('info', first, '--json'));
  assert.equal(facts.frames, FRAMES);
  run('export', first, '-o', second);
  const { messages, statistics } = await messagesOf(second);
  assert.equal(statistics.messageCount, BigInt(2 * FRAMES));
  const depth = messages['/camera/depth/image_rect_raw'];
  assert.equal(depth.length, FRAMES);
  depth.forEach(({ data, logTime, schema }, frame) => {
    assert.equal(schema.name, 'sensor_msgs/msg/Image');
    assert.equal(logTime, BigInt(100 + frame) * SECOND);
    assert.deepEqual(data.slice(-pixels(frame).length), pixels(frame));
  });
});

// Whether a value has the fields and types of a schema, and no others.
function conforms(value, schema, path) {
  if (schema.type === 'object') {
    assert.equal(typeof value, 'object', path);
    const fields = schema.properties ?? {};
    assert.deepEqual(Object.keys(value).sort(), Object.keys(fields).sort(), path);
    for (const [name, field] of Object.entries(fields)) conforms(value[name], field, `${path}.${name}`);
  } else if (schema.type === 'array') {
    assert.ok(Array.isArray(value), path);
    value.forEach((item, i) => conforms(item, schema.items, `${path}[${i}]`));
  } else if (schema.type === 'integer' || schema.type === 'number') {
    assert.equal(typeof value, 'number', path);
  } else if (schema.type) {
    assert.equal(typeof value, schema.type, path);
  }
}

const cloud = (observed) => `ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property float nx
property float ny
property float nz
${observed ? 'property uchar observed\n' : ''}end_header
0 0 0 0 0 1${observed}
0.1 0 0 0 0 1${observed}
0 0.1 0 0 0 1${observed}
`;
const SURFACE = 'v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\ng observed\nf 1 3 2\nf 1 2 4\ng inferred\nf 2 3 4\nf 1 4 3\n';

async function writeResult(dir) {
  await mkdir(join(dir, 'objects'), { recursive: true });
  await writeFile(join(dir, 'cloud.ply'), cloud(''));
  await writeFile(join(dir, 'objects', '0.ply'), cloud(' 1'));
  await writeFile(join(dir, 'objects', '0.obj'), SURFACE);
  const pose = { position_m: [0.1, 0.2, 0.3], orientation_xyzw: [0, 0, 0, 1] };
  const item = {
    id: 0, points: [0, 1, 2], score: 0.5, confidence: 0.25, cloud: 'objects/0.ply', surface: 'objects/0.obj', T_world_object: pose, box: { T_world_box: pose, size_m: [1, 1, 1] },
    rotational: [{ point: [0, 0, 0], direction: [0, 0, 1], residual: 0.01 }], reflectional: [{ point: [0, 0, 0], normal: [1, 0, 0], residual: 0.01 }],
  };
  await writeFile(join(dir, 'objects.json'), JSON.stringify({ version: 3, cloud: 'cloud.ply', objects: [item], rejected: [], funnel: [], timings: {} }));
}

test('a result is messages of Foxglove\'s schemas', async () => {
  const result = join(folder, 'result'), file = join(folder, 'result.mcap');
  await writeResult(result);
  run('export', result, '-o', file);
  const { messages } = await messagesOf(file);
  assert.deepEqual(Object.keys(messages).sort(), ['/cloud', '/objects', '/poses', '/symmetries']);
  for (const [topic, [message]] of Object.entries(messages)) {
    const schema = schemas.find(({ title }) => title === message.schema.name);
    assert.ok(schema, message.schema.name);
    conforms(JSON.parse(Buffer.from(message.data)), schema, topic);
  }
  const [entity] = JSON.parse(Buffer.from(messages['/objects'][0].data)).entities;
  assert.equal(entity.triangles[0].indices.length, 12);
  const cloud = JSON.parse(Buffer.from(messages['/cloud'][0].data));
  assert.ok(Math.abs(Buffer.from(cloud.data, 'base64').readFloatLE(cloud.point_stride) - 0.1) < 1e-6);
});
