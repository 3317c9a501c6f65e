// The review page in a browser, from the command's page to the command that reads its choices.
// SYMSCENE_COMMAND is the built command; without it a page is made from a payload here.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe } from 'node:test';
import { promisify } from 'node:util';
import { browserTest } from './browser.mjs';
import { encodeSurface, writePage } from './payload.mjs';

const WINDOW = { viewport: { width: 1000, height: 640 } };
const HOSTILE = '</script><img src=x onerror="window.hacked=1">';
const command = process.env.SYMSCENE_COMMAND;

const CORNERS = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [k & 1 ? 0.05 : -0.05, k & 2 ? 0.08 : -0.08, k & 4 ? 0.115 : -0.115]);
const FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
  .flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);

const symmetry = (kind, direction, order = null) =>
  ({ kind, order, point: [0, 0, 0], direction, residual_mm: 0.1, residual_percent: 0.03 });
const BOX = [symmetry('axis', [0, 0, 1], 2), symmetry('plane', [1, 0, 0]), symmetry('plane', [0, 1, 0])];

function model(name, symmetries) {
  const surface = encodeSurface({ positions: CORNERS, colors: [], triangles: FACES });
  return { name, diameter_mm: 297, diagonal_mm: 297, diagonal: 0.297, surface, symmetries };
}

function boxFile() {
  const vertices = CORNERS.map((p) => `v ${p.join(' ')}`);
  return `${[...vertices, ...FACES.map((face) => `f ${face.map((k) => k + 1).join(' ')}`)].join('\n')}\n`;
}

let folder;
let path;

before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'symscene-review-'));
  path = join(folder, 'review.html');
  const title = `Symmetries of ${HOSTILE}`;
  const models = [model('box', BOX), model(HOSTILE, [symmetry('axis', [0, 0, 1], 'continuous')]), model('shoe', [])];
  await writePage(path, { version: 1, title, models }, 'review.html');
});

after(() => rm(folder, { recursive: true, force: true }));

// Choices are kept in the page, so that each test loads it.
const reviewTest = (name, body, page = () => path, { skip = false } = {}) =>
  browserTest(name, page, WINDOW, body, { isFresh: true, skip });

const hook = (page, expression) => page.evaluate(`window.symscene.${expression}`);
const words = async (page, m) => (await hook(page, 'choices')).models[m].symmetries.map(({ choice }) => choice);

async function saved(page, act) {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  assert.equal(download.suggestedFilename(), 'choices.json');
  const file = join(folder, 'choices.json');
  await download.saveAs(file);
  return file;
}

describe('the review page', () => {
  reviewTest('lists models and symmetries with their residuals', async (page) => {
    assert.equal(await page.locator('.model').count(), 3);
    assert.equal(await page.locator('.symmetry').count(), 3);
    assert.match(await page.textContent('.symmetry'), /Axis, 2-fold.*0\.10 mm, 0\.03 %/);
    assert.match(await page.textContent('.progress'), /0 of 4/);
    assert.equal(await page.evaluate('window.hacked'), undefined);
  });

  reviewTest('takes choices by mouse, moves on, and can take them back', async (page) => {
    await page.click('.symmetry:nth-child(2) .reject');
    assert.deepEqual(await words(page, 0), ['open', 'rejected', 'open']);
    await page.click('.symmetry:nth-child(1) .accept');
    assert.equal(await hook(page, 'selected'), 2, 'the next open one');
    await page.click('.symmetry:nth-child(2) .reject');
    assert.deepEqual(await words(page, 0), ['accepted', 'open', 'open']);
  });

  reviewTest('takes choices by keys and goes through the models', async (page) => {
    await page.keyboard.press('a');
    await page.keyboard.press('r');
    await page.keyboard.press('a');
    assert.deepEqual(await words(page, 0), ['accepted', 'rejected', 'accepted']);
    assert.equal(await hook(page, 'model'), HOSTILE);
    await page.keyboard.press('a');
    assert.match(await page.textContent('.progress'), /4 of 4/);
    await page.click('.model:nth-child(3)');
    assert.match(await page.textContent('.side'), /No symmetry was found/);
    await page.keyboard.press('a');
    await page.keyboard.press('ArrowDown');
  });

  reviewTest('draws the selected symmetry and the moved copy', async (page) => {
    const picture = async () => page.locator('canvas').screenshot().then((data) => data.toString('base64'));
    const first = await picture();
    await page.keyboard.press('ArrowDown');
    await page.waitForTimeout(300);
    assert.notEqual(await picture(), first);
    assert.match(await page.textContent('.tag'), /2-fold/);
  });

  reviewTest('saves the choices, and continues from them', async (page) => {
    await page.keyboard.press('r');
    const file = await saved(page, () => page.click('.save'));
    const choices = JSON.parse(await readFile(file, 'utf8'));
    assert.equal(choices.version, 1);
    assert.deepEqual(choices.models[0].symmetries[0],
      { kind: 'axis', order: 2, point: [0, 0, 0], direction: [0, 0, 1], choice: 'rejected' });
    await page.reload();
    await page.setInputFiles('input[type=file]', file);
    await page.waitForFunction(() => window.symscene.choices.models[0].symmetries[0].choice === 'rejected');
    choices.models[0].symmetries = [
      { kind: 'axis', order: 4, point: [0, 0, 0], direction: [0, 0, 1], choice: 'accepted' },
      { kind: 'axis', order: 2, point: [0.002, 0, 0.1], direction: [0, 0.015, -1], choice: 'accepted' },
      { kind: 'plane', point: [0.004, 0, 0], direction: [1, 0, 0], choice: 'accepted' },
      { kind: 'plane', point: [0.1, 0.002, 0.1], direction: [0, -1, 0], choice: 'rejected' }];
    const near = { name: 'near.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(choices)) };
    await page.reload();
    await page.setInputFiles('input[type=file]', near);
    await page.waitForFunction(() => /2 choices of near\.json/.test(document.querySelector('.hint').textContent));
    assert.deepEqual(await words(page, 0), ['accepted', 'open', 'rejected'], 'within 1° and 1 % of the diagonal, of the same order');
    await page.setInputFiles('input[type=file]', { name: 'no.json', mimeType: 'application/json', buffer: Buffer.from('{}') });
    await page.waitForFunction(() => /no\.json cannot be read/.test(document.querySelector('.hint').textContent));
  });
});

describe('the command and the review page', () => {
  const run = (...line) => promisify(execFile)(command, ['symmetry', ...line], { cwd: folder });
  const options = { skip: !command };

  before(async () => {
    if (!command) return;
    await writeFile(join(folder, 'obj_000001.obj'), boxFile());
    await run('obj_000001.obj', '--review', 'made.html');
  });

  reviewTest('leaves out what was rejected on its page', async (page) => {
    assert.equal(await page.locator('.symmetry').count(), 6);
    await page.click('.symmetry:nth-child(1) .reject');
    await saved(page, () => page.keyboard.press('s'));
    const { stdout } = await run('obj_000001.obj', '--reviewed', 'choices.json', '--format', 'bop');
    assert.equal(JSON.parse(stdout)['1'].symmetries_discrete.length, 1, 'two half turns would make the third');
  }, () => join(folder, 'made.html'), options);
});
