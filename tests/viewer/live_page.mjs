// The page of a live scene in a browser, served by a small server here and, if SYMSCENE_COMMAND names it, by the command.
import assert from 'node:assert/strict';
import { execFile, spawn } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe } from 'node:test';
import { promisify } from 'node:util';
import { servedTest } from './browser.mjs';

const WINDOW = { viewport: { width: 1000, height: 640 } };
const TOKEN = '0123456789abcdef';
const command = process.env.SYMSCENE_COMMAND;

const object = (number, x) => ({ number, points: 300, score: 0.9, center: [x, 0, 0.05], axes: 1, planes: 0, class: 'revolution' });
const change = (number, kind) => ({ number, kind });

// Three updates: two objects, a third one, and the first taken away.
const REPORTS = [
  { objects: [object(1, -0.2), object(2, 0)], changes: [change(1, 'appeared'), change(2, 'appeared')] },
  { objects: [object(3, 0.2), object(1, -0.2), object(2, 0)], changes: [change(3, 'appeared')] },
  { objects: [object(2, 0), object(3, 0.2)], changes: [change(1, 'gone')] },
].map((report, i) => ({ update: i + 1, frames: 30 * (i + 1), lost: 0, latency: 0.4, spacing: 0.005, points: 900, table: [0, 0, 1, 0], warnings: [], ...report }));

/** An update as docs/formats.md describes it: 300 points of each object, thinned evenly. */
function encodeUpdate(report, most) {
  const all = report.objects.flatMap(({ center }, k) => Array.from({ length: 300 }, (_, i) => ({
    object: k + 1, place: [center[0] + 0.04 * Math.cos(i), center[1] + 0.04 * Math.sin(i), (0.1 * i) / 300] })));
  const count = Math.min(most, all.length);
  const points = Array.from({ length: count }, (_, k) => all[Math.floor((k * all.length) / count)]);
  const json = Buffer.from(JSON.stringify(report));
  const padded = Buffer.concat([json, Buffer.alloc((4 - (json.length % 4)) % 4, ' ')]);
  const header = Buffer.alloc(36);
  header.write('SYL1');
  [padded.length, count, all.length, 0].forEach((value, i) => header.writeUInt32LE(value, 4 + 4 * i));
  [-0.5, -0.5, -0.5, 1 / 65535].forEach((value, i) => header.writeFloatLE(value, 20 + 4 * i));
  const values = Buffer.alloc(8 * count);
  points.forEach(({ object: at, place }, i) => {
    [...place.map((value) => Math.round((value + 0.5) * 65535)), at].forEach((value, k) => values.writeUInt16LE(value, 8 * i + 2 * k));
  });
  return Buffer.concat([header, padded, values]);
}

class Server {
  streams = new Set();
  sent = 1;
  run = 'first';
  isFinished = false;

  async start(page, port = 0) {
    this.page = page;
    this.http = createServer((request, reply) => this.#answer(request, reply));
    await new Promise((resolve) => { this.http.listen(port, '127.0.0.1', resolve); });
    this.port = this.http.address().port;
  }

  get url() { return `http://127.0.0.1:${this.port}/?token=${TOKEN}`; }

  #answer(request, reply) {
    const url = new URL(request.url, 'http://127.0.0.1');
    if (url.searchParams.get('token') !== TOKEN) { reply.writeHead(403).end(); return; }
    if (url.pathname === '/events') {
      reply.writeHead(200, { 'Content-Type': 'text/event-stream' });
      this.streams.add(reply);
      this.#tell(reply);
    } else if (url.pathname.startsWith('/updates/')) {
      const report = REPORTS[Number(url.pathname.slice(9)) - 1];
      if (report) reply.writeHead(200).end(encodeUpdate(report, Number(url.searchParams.get('points'))));
      else reply.writeHead(404).end();
    } else reply.writeHead(200, { 'Content-Type': 'text/html; charset=utf-8' }).end(this.page);
  }

  #tell(reply) {
    reply.write(`id: ${this.run}-${this.sent}\ndata: ${JSON.stringify({ run: this.run, oldest: 1, report: REPORTS[this.sent - 1] })}\n\n`);
    if (this.isFinished) reply.write('event: finished\ndata: {}\n\n');
  }

  publish(update) {
    this.sent = update;
    for (const stream of this.streams) this.#tell(stream);
  }

  finish() {
    this.isFinished = true;
    for (const stream of this.streams) this.#tell(stream);
  }

  async stop() {
    for (const stream of this.streams) stream.destroy();
    this.streams.clear();
    this.http.closeAllConnections();
    await new Promise((resolve) => { this.http.close(resolve); });
  }
}

const shown = (page, update) => page.waitForFunction((n) => window.symscene?.state.shown === n && window.symscene.drawn, update, { timeout: 60000 });
const labels = async (page) => (await page.evaluate('window.symscene.labels')).sort();
const rows = (page) => page.$$eval('.objects li', (list) => list.map((row) => row.dataset.number));
const facts = (page) => page.textContent('.facts');

describe('the page of a live scene', () => {
  const server = new Server();

  before(async () => {
    const template = await readFile(new URL('../../viewer/dist/live.html', import.meta.url), 'utf8');
    const page = template.replaceAll('@@SYMSCENE_TITLE@@', 'sweep').replace('"@@SYMSCENE_PAYLOAD@@"', '{"title": "a </b> sweep"}');
    await server.start(page);
  });
  after(() => server.stop());

  servedTest('follows the updates, keeps one while it is paused, and goes back to them', async () => `http://127.0.0.1:${server.port}/`, WINDOW, async (page, trouble) => {
    await page.goto(server.url);
    await shown(page, 1);
    assert.deepEqual(await labels(page), ['1', '2']);
    assert.equal(await page.textContent('h1'), 'a </b> sweep');
    server.publish(2);
    await shown(page, 2);
    assert.deepEqual(await rows(page), ['1', '2', '3']);
    const picture = (await page.screenshot()).toString('base64');

    await page.click('.follow');
    server.publish(3);
    await page.waitForFunction(() => window.symscene.state.newest === 3);
    assert.equal(await page.evaluate('window.symscene.state.shown'), 2);
    assert.match(await page.textContent('.log li:first-child'), /^1is gone after 90 frames$/);
    await page.click('.follow');
    await shown(page, 3);
    assert.deepEqual(await rows(page), ['2', '3']);
    assert.notEqual((await page.screenshot()).toString('base64'), picture);

    await page.focus('.updates');
    await page.keyboard.press('Home');
    await shown(page, 1);
    assert.deepEqual(await rows(page), ['1', '2']);
    assert.equal(await page.textContent('.follow'), 'Paused');
    assert.deepEqual(trouble, []);
  });

  servedTest('draws no more points than it is asked to', async () => `http://127.0.0.1:${server.port}/`, WINDOW, async (page) => {
    await page.goto(server.url);
    await page.waitForFunction(() => window.symscene?.state.shown > 0);
    assert.match(await facts(page), /600 points$/);
    await page.evaluate(() => {
      const select = document.querySelector('.budget');
      select.append(new Option('few', '100'));
      select.value = '100';
      select.dispatchEvent(new Event('change'));
    });
    await page.waitForFunction(() => / 100 of 600 points$/.test(document.querySelector('.facts').textContent));
  });

  servedTest('says that the connection is lost, goes on when it is back, and begins anew with another run', async () => `http://127.0.0.1:${server.port}/`, WINDOW, async (page) => {
    await page.goto(server.url);
    await shown(page, server.sent);
    const { port } = server;
    await server.stop();
    await page.waitForSelector('.state[data-state="lost"]');
    server.sent = 3;
    await server.start(server.page, port);
    await page.waitForSelector('.state[data-state="live"]', { timeout: 30000 });
    await shown(page, 3);
    await page.evaluate(() => { window.isOld = true; });
    await server.stop();
    server.run = 'second';
    await server.start(server.page, port);
    await page.waitForFunction(() => !window.isOld && window.symscene?.state.shown === 3, null, { timeout: 60000 });
    server.finish();
    await page.waitForSelector('.state[data-state="finished"]');
  });
});

describe('symscene watch', { skip: !command }, () => {
  let folder;
  let child;
  let address;

  before(async () => {
    if (!command) return;
    folder = await mkdtemp(join(tmpdir(), 'symscene-live-'));
    await writeFile(join(folder, 'sweep.json'), JSON.stringify({ tabletop: { objects: 4 },
      camera: { frames: 8, arc: 0.06, radius: 0.7, width: 320, height: 240, focal_length: 262 } }));
    await promisify(execFile)(command, ['simulate', '--sequence', '-o', 'sweep', '--config', 'sweep.json'], { cwd: folder });
    child = spawn(command, ['watch', 'sweep', '--token', TOKEN, '--fast', '-o', 'result'], { cwd: folder });
    address = await new Promise((resolve, reject) => {
      let text = '';
      child.stdout.on('data', (bytes) => {
        text += bytes;
        const found = text.match(/open (http:\S+)/);
        if (found) resolve(found[1]);
      });
      child.on('exit', () => reject(new Error(`symscene watch ended: ${text}`)));
      setTimeout(() => reject(new Error(`symscene watch tells no address: ${text}`)), 60000).unref();
    });
  });
  after(async () => {
    child?.kill('SIGKILL');
    if (folder) await rm(folder, { recursive: true, force: true });
  });

  servedTest('serves a page with the objects of the last frame, to those who have the token, until it is interrupted', async () => new URL('/', address).href, WINDOW, async (page, trouble) => {
    await page.goto(address);
    await page.waitForSelector('.state[data-state="finished"]', { timeout: 90000 });
    const { newest } = await page.evaluate('window.symscene.state');
    await shown(page, newest);
    const objects = JSON.parse(await readFile(join(folder, 'result', 'objects.json'), 'utf8')).objects.length;
    assert.ok(objects > 0);
    assert.equal((await rows(page)).length, objects);
    assert.match(await facts(page), / 8 frames/);
    assert.deepEqual(trouble, []);
    for (const path of ['/', '/events', '/updates/1']) {
      assert.equal((await fetch(new URL(path, address))).status, 403, path);
      assert.equal((await fetch(new URL(`${path}?token=${TOKEN}0`, address))).status, 403, path);
    }
    await assert.rejects(promisify(execFile)(command, ['watch', 'sweep', '--port', new URL(address).port], { cwd: folder, timeout: 60000 }), /an address that is free/);
    assert.equal((await fetch(new URL(`/updates/999?token=${TOKEN}`, address))).status, 404);
    const ended = new Promise((resolve) => { child.on('exit', resolve); });
    child.kill('SIGINT');
    assert.equal(await ended, 0);
  });
});
