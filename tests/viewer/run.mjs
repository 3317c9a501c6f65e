// The page in a browser: node --test run.mjs, after `npm ci && npm run build` in viewer/.
// CHROMIUM names the browser; SYMSCENE_PAGE and SYMSCENE_RUN_PAGE are pages made by C++ (make_page) to test too, SYMSCENE_COMMAND the command
// whose review page is tested.
import assert from 'node:assert/strict';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe } from 'node:test';
import { browserTest, drawn } from './browser.mjs';
import { bareTable, emptyResult, noPoints, tabletop } from './fixture.mjs';
import { writePage } from './payload.mjs';
import './modules.mjs';
import './review.mjs';
import './live_page.mjs';
import './explore_page.mjs';
import './run_modules.mjs';
import './run_page.mjs';

// Tests run without a graphics card, so that those not about layout use a small window.
const WINDOW = { viewport: { width: 860, height: 480 } };
const DESKTOP = { viewport: { width: 1280, height: 800 } };
const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };
const HOSTILE = '</title></script><script>window.hacked=1</script><img src=x onerror="window.hacked=1">';

let folder;
const pages = {};

before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'symscene-pages-'));
  const scenes = { tabletop: tabletop(), scanned: tabletop({ scan: true, compared: true }), closed: tabletop({ closed: true }), grasps: tabletop({ closed: true, grasps: {} }), views: tabletop({ views: true }), noGrasps: tabletop({ grasps: { max_opening: 0.01 } }),
    threeFingers: tabletop({ grasps: { kind: 'three_finger', finger_spacing: 0.05, max_opening: 0.16 } }), empty: emptyResult(), noPoints: noPoints(), bare: bareTable(), hostile: hostileScene() };
  for (const [name, scene] of Object.entries(scenes)) {
    pages[name] = join(folder, `${name}.html`);
    await writePage(pages[name], scene);
  }
});

after(() => rm(folder, { recursive: true, force: true }));

function hostileScene() {
  const scene = tabletop({ title: HOSTILE });
  scene.note = HOSTILE;
  scene.timings[0].stage = HOSTILE;
  scene.funnel[0].step = HOSTILE;
  scene.warnings = [HOSTILE, 'no occupancy map'];
  Object.assign(scene.rejected[0], { reason: HOSTILE, kind: HOSTILE });
  return scene;
}

const hook = (page, expression) => page.evaluate(`window.symscene.${expression}`);
const pressed = (page, selector) => page.getAttribute(selector, 'aria-pressed');

/** Boxes that must not meet: panel, groups of controls, labels. */
function layoutProblems(page) {
  return page.evaluate(() => {
    const seen = (element) => getComputedStyle(element).visibility !== 'hidden';
    const boxes = [...document.querySelectorAll('.panel, .group, .label')].filter(seen)
      .map((element) => ({ name: `${element.className} ${element.textContent.slice(0, 12)}`, box: element.getBoundingClientRect() }));
    const problems = [];
    boxes.forEach(({ name, box: a }, i) => {
      if (a.left < 0 || a.top < 0 || a.right > innerWidth + 0.5 || a.bottom > innerHeight + 0.5) problems.push(`${name} leaves the window`);
      for (const { name: other, box: b } of boxes.slice(0, i)) {
        if (a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 0.5 && b.top < a.bottom - 0.5) problems.push(`${name} meets ${other}`);
      }
    });
    for (const element of document.querySelectorAll('.scroll, .object .row, .name, .group')) {
      if (element.scrollWidth > element.clientWidth + 1) problems.push(`${element.className} overflows`);
    }
    return problems;
  });
}

describe('a result with objects', () => {
  const path = () => pages.tabletop;

  browserTest('begins again as it began', path, WINDOW, async (page) => {
    const { hash } = await hook(page, 'pixels()');
    await hook(page, 'select(2)');
    for (const key of ['p', 'x', 't', '1']) await page.keyboard.press(key);
    await drawn(page);
    assert.notEqual((await hook(page, 'pixels()')).hash, hash);
    await hook(page, 'reset()');
    await drawn(page);
    assert.equal((await hook(page, 'pixels()')).hash, hash);
    assert.equal(await hook(page, 'selected'), null);
  });

  browserTest('draws and lists the scene, then stops drawing', path, WINDOW, async (page) => {
    assert.equal(await page.locator('.object').count(), 8);
    assert.equal(await page.locator('.label').count(), 8);
    assert.equal(await page.title(), 'Synthetic tabletop');
    const { filled } = await hook(page, 'pixels()');
    assert.ok(filled > 0.1 && filled < 0.9, `${filled} of the canvas is filled`);
    await page.waitForFunction(() => window.symscene.rested);
    const frames = await hook(page, 'frames');
    await page.waitForTimeout(600);
    assert.equal(await hook(page, 'frames'), frames, 'nothing is drawn while nothing changes');
  });

  browserTest('chooses its detail by a frame that it measured', path, WINDOW, async (page) => {
    assert.ok((await hook(page, 'detail')).restDelay > 0);
  });

  browserTest('shows and hides objects', path, WINDOW, async (page) => {
    const everything = await hook(page, 'pixels()');
    await page.click('.object:nth-child(3) .eye');
    assert.deepEqual(await hook(page, 'visible'), [0, 1, 3, 4, 5, 6, 7]);
    assert.notEqual((await hook(page, 'pixels()')).hash, everything.hash);
    await page.click('.object:nth-child(5) [aria-label^="Show only"]');
    assert.deepEqual(await hook(page, 'visible'), [4]);
    await page.click('.chip >> text=None');
    assert.deepEqual(await hook(page, 'visible'), []);
    const nothing = await hook(page, 'pixels()');
    assert.ok(nothing.filled < 0.5 * everything.filled);
    await page.click('.chip >> text=All');
    assert.equal((await hook(page, 'pixels()')).hash, everything.hash);
  });

  browserTest('draws every visible layer', path, WINDOW, async (page) => {
    const hashes = [(await hook(page, 'pixels()')).hash];
    for (const key of ['planes', 'axes', 'rest', 'completed']) {
      const before = await pressed(page, `[data-toggle=${key}]`);
      await page.click(`[data-toggle=${key}]`);
      assert.notEqual(await pressed(page, `[data-toggle=${key}]`), before);
      hashes.push((await hook(page, 'pixels()')).hash);
    }
    for (const mode of ['scan', 'objects']) {
      await page.click(`[data-mode=${mode}]`);
      hashes.push((await hook(page, 'pixels()')).hash);
    }
    assert.equal(new Set(hashes).size, hashes.length, 'every change is seen');
  });

  browserTest('has no toggle for a missing mesh and path', path, WINDOW, async (page) => {
    assert.equal(await page.locator('[data-toggle=mesh], [data-toggle=path]').count(), 0);
    const before = await hook(page, 'pixels()');
    await page.keyboard.press('m');
    await page.keyboard.press('v');
    assert.equal((await hook(page, 'pixels()')).hash, before.hash);
    assert.equal(await hook(page, 'mesh'), false);
    assert.equal(await hook(page, 'path'), false);
  });

  browserTest('offers no grasps without any', path, WINDOW, async (page) => {
    assert.equal(await page.locator('[data-toggle=grasps], .grasp-section').count(), 0);
    assert.deepEqual(await hook(page, 'grasps'), []);
  });

  browserTest('has no list of warnings without any', path, WINDOW, async (page) => {
    assert.equal(await page.locator('.warnings').count(), 0);
  });

  browserTest('has a dark scheme', path, { ...WINDOW, colorScheme: 'dark' }, async (page) => {
    const color = await page.evaluate(() => getComputedStyle(document.querySelector('.panel')).backgroundColor);
    assert.ok(color.match(/\d+/g).slice(0, 3).every((value) => Number(value) < 80), color);
  });

  browserTest('selects the clicked object', path, WINDOW, async (page) => {
    for (const id of [0, 2, 5]) {
      const { x, y } = await hook(page, `clickPoint(${id})`);
      await page.mouse.click(x, y);
      assert.equal(await hook(page, 'selected'), id);
      assert.match(await page.textContent('.object.selected .details'), /Points seen.*Centroid/s);
    }
    await page.mouse.click(30, 400);
    assert.equal(await hook(page, 'selected'), null);
    await page.click('.object:nth-child(2) .pick');
    assert.equal(await hook(page, 'selected'), 1);
  });

  browserTest('handles the keyboard', path, WINDOW, async (page) => {
    await page.keyboard.press(']');
    assert.equal(await hook(page, 'selected'), 0);
    await page.keyboard.press('Escape');
    assert.equal(await hook(page, 'selected'), null);
    await page.keyboard.press('p');
    assert.equal(await pressed(page, '[data-toggle=planes]'), 'false');
    const before = (await hook(page, 'pixels()')).hash;
    await page.focus('canvas');
    await page.keyboard.press('ArrowLeft');
    await drawn(page);
    assert.notEqual((await hook(page, 'pixels()')).hash, before);
    await page.keyboard.press('Tab');
    assert.notEqual(await page.evaluate('document.activeElement.tagName'), 'CANVAS', 'the canvas is no trap');
  });

  browserTest('takes its view from the address', path, WINDOW, async (page) => {
    assert.equal(await hook(page, 'selected'), 3);
    assert.equal(await hook(page, 'mode'), 'objects');
    assert.deepEqual(await hook(page, 'visible'), [1, 3]);
    assert.deepEqual(await hook(page, 'completed'), [3]);
    assert.equal(await pressed(page, '[data-toggle=planes]'), 'false');
  }, { hash: '#view=top&select=3&mode=objects&only=1,3&completed=3&planes=0', isFresh: true });

  browserTest('keeps what it shows in the address, and finds it there again', path, WINDOW, async (page) => {
    assert.equal(await hook(page, 'hash'), '');
    await hook(page, 'select(2)');
    await page.keyboard.press('p');
    await page.focus('canvas');
    await page.keyboard.press('ArrowLeft');
    await page.waitForFunction(() => location.hash === `#${window.symscene.hash}`);
    const hash = await hook(page, 'hash');
    assert.match(hash, /^camera=[-\d.,]+&planes=0&select=2$/);
    const shown = (await hook(page, 'pixels()')).filled;
    await hook(page, 'reset()');
    await page.evaluate((text) => { location.hash = ''; location.hash = text; }, hash);
    await page.waitForFunction((text) => window.symscene.hash === text, hash);
    assert.ok(Math.abs((await hook(page, 'pixels()')).filled - shown) < 0.002);
  });

  browserTest('tells what decided the score of an object, for and against', path, WINDOW, async (page) => {
    await hook(page, 'select(1)');
    const text = await page.textContent('.object.selected .effects');
    assert.match(text, /For an object.*misfit of its best axis0\.01, usually 1\+1\.9.*convex.*Against.*points beside other things.*−0\.4/s);
  });

  browserTest('groups rejected hypotheses by reason and shows the clicked one', path, WINDOW, async (page) => {
    await page.click('.why-section > summary');
    const reasons = await page.locator('.reason').evaluateAll((groups) => groups.map((group) => group.dataset.reason));
    assert.equal(new Set(reasons).size, reasons.length);
    await page.click('.reason[data-reason=symmetry] summary');
    const row = page.locator('.reason[data-reason=symmetry] [data-rejection]').first();
    const before = await hook(page, 'pixels()');
    await row.click();
    assert.equal(String(await hook(page, 'rejection')), await row.getAttribute('data-rejection'));
    assert.ok(await page.locator('.reason[data-reason=symmetry] .effects').first().isVisible());
    const marked = await hook(page, 'pixels()');
    assert.notEqual(marked.hash, before.hash);
    assert.equal(await page.locator('.reason[data-reason=occlusion] [data-rejection]:enabled').count(), 0, 'their points are not known');
    await row.click();
    await page.mouse.move(1, 240);
    await drawn(page);
    assert.equal((await hook(page, 'pixels()')).hash, before.hash);
  });

  browserTest('shows the rejected hypothesis that the address names', path, WINDOW, async (page) => {
    assert.equal(await hook(page, 'rejection'), 5);
    assert.ok(await page.locator('[data-rejection="5"]').isVisible());
  }, { hash: '#rejected=5' });

  browserTest('shows what a new address asks for, even where its own was about to be written', path, WINDOW, async (page) => {
    await page.evaluate(() => {
      location.hash = '#rejected=4'; // the browser tells of it later
      document.querySelector('[title="Copy the address of this view"]').click();
    });
    await page.waitForFunction(() => window.symscene.rejection === 4);
    await page.waitForFunction(() => location.hash === '#rejected=4');
    await hook(page, 'reset()');
    await page.waitForFunction(() => location.hash === '');
  });

  browserTest('measures the distance between two clicked points', path, WINDOW, async (page) => {
    await page.click('[data-toggle=measure]');
    assert.match(await page.textContent('.hint'), /Click two points/);
    const [from, to] = [await hook(page, 'clickPoint(0)'), await hook(page, 'clickPoint(4)')];
    for (const { x, y } of [from, to]) await page.mouse.click(x, y);
    const [a, b] = await hook(page, 'marks');
    const centimetres = 100 * Math.hypot(...a.map((value, k) => value - b[k]));
    assert.ok(centimetres > 5 && centimetres < 60);
    assert.equal(Number.parseFloat(await page.textContent('.distance')), Number(centimetres.toFixed(1)));
    assert.equal(await hook(page, 'selected'), null, 'a click measures and does not select');
    await page.keyboard.press('Escape');
    assert.deepEqual(await hook(page, 'marks'), []);
  });

  browserTest('saves a picture of the view, and copies the pose of an object', path, WINDOW, async (page, context) => {
    const [saved] = await Promise.all([page.waitForEvent('download'), page.click('.exports >> text=PNG')]);
    assert.equal(saved.suggestedFilename(), 'Synthetic-tabletop.png');
    assert.ok((await hook(page, 'picture()')).length > 20000, 'more than an empty picture');
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await hook(page, 'select(0)');
    await page.click('.object.selected >> text=Copy pose');
    await page.waitForSelector('.object.selected >> text=Copied');
    const { id, T_world_object: pose, size_m: size } = JSON.parse(await page.evaluate(() => navigator.clipboard.readText()));
    assert.deepEqual([id, pose.orientation_xyzw, size], [0, [0, 0, 0, 1], [0.07, 0.08, 0.2]]);
  });

  browserTest('saves all objects as one glTF file in the frame of the result', path, WINDOW, async (page) => {
    const bytes = Buffer.from(await hook(page, 'glb()'));
    assert.equal(bytes.toString('latin1', 0, 4), 'glTF');
    assert.equal(bytes.readUInt32LE(8), bytes.length);
    const document = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
    assert.equal(document.meshes.length, 8);
    assert.deepEqual(document.nodes[0].children, [1, 2, 3, 4, 5, 6, 7, 8]);
    const { min, max } = document.accessors[document.meshes[0].primitives[0].attributes.POSITION];
    assert.ok(Math.abs(max[2] - 0.235) < 0.01 && min[2] > -0.01, 'z is up, the can 23.5 cm high');
    assert.ok(document.bufferViews.every(({ byteOffset, byteLength }) => byteOffset + byteLength <= document.buffers[0].byteLength));
  });

  const sizes = {
    'a desk': DESKTOP,
    'a tablet': { viewport: { width: 768, height: 1024 } },
    'a small window': { viewport: { width: 1100, height: 600 } },
    'a phone': PHONE,
    'a small phone': { ...PHONE, viewport: { width: 340, height: 640 } },
    'a phone on its side': { ...PHONE, viewport: { width: 667, height: 375 } },
  };
  for (const [size, options] of Object.entries(sizes)) {
    browserTest(`has nothing that covers another thing on ${size}`, path, options, async (page) => {
      for (const view of ['home', 'front', 'side', 'top']) {
        await hook(page, `view('${view}')`);
        await drawn(page);
        assert.deepEqual(await layoutProblems(page), [], view);
      }
      await hook(page, 'select(4)');
      await drawn(page);
      assert.deepEqual(await layoutProblems(page), []);
    });
  }

  browserTest('gives the scene most of a phone, with a movable sheet', path, PHONE, async (page) => {
    const top = () => page.evaluate(() => document.querySelector('.panel').getBoundingClientRect().top);
    const half = await top();
    assert.ok(half > 0.55 * 844);
    await page.click('.grip');
    assert.ok((await top()) < half);
    await page.click('.grip');
    assert.ok((await top()) > half);
    await drawn(page);
    assert.deepEqual(await layoutProblems(page), []);
    const { x, y } = await hook(page, 'clickPoint(5)');
    await page.touchscreen.tap(x, y);
    assert.equal(await hook(page, 'selected'), 5);
  });
});

describe('a result with the surface that was reconstructed', () => {
  const path = () => pages.scanned;

  browserTest('shows the mesh by default, and can hide it', path, WINDOW, async (page) => {
    assert.equal(await hook(page, 'mesh'), true);
    assert.equal(await hook(page, 'path'), false);
    const shown = await hook(page, 'pixels()');
    await page.click('[data-toggle=mesh]');
    assert.equal(await pressed(page, '[data-toggle=mesh]'), 'false');
    const hidden = await hook(page, 'pixels()');
    assert.ok(hidden.filled < 0.7 * shown.filled, 'the table is part of the mesh');
    await page.keyboard.press('m');
    assert.equal((await hook(page, 'pixels()')).hash, shown.hash);
  });

  browserTest('colours the mesh by visible objects', path, WINDOW, async (page) => {
    const hashes = [(await hook(page, 'pixels()')).hash];
    for (const key of ['1', '3']) {
      await page.keyboard.press(key);
      hashes.push((await hook(page, 'pixels()')).hash);
    }
    await page.click('.chip >> text=None');
    hashes.push((await hook(page, 'pixels()')).hash);
    assert.equal(new Set(hashes).size, hashes.length);
    assert.ok((await hook(page, 'pixels()')).filled > 0.3, 'the mesh stays where its objects are off');
  });

  browserTest('selects the clicked object on the mesh', path, WINDOW, async (page) => {
    for (const id of [0, 2, 5]) {
      const { x, y } = await hook(page, `clickPoint(${id})`);
      await page.mouse.click(x, y);
      assert.equal(await hook(page, 'selected'), id);
    }
  });

  browserTest('shows the path of the camera, and frames it', path, WINDOW, async (page) => {
    const before = await hook(page, 'pixels()');
    await page.keyboard.press('v');
    assert.equal(await hook(page, 'path'), true);
    assert.equal(await pressed(page, '[data-toggle=path]'), 'true');
    await drawn(page);
    assert.ok((await hook(page, 'pixels()')).filled < before.filled, 'seen from farther away');
    assert.deepEqual(await layoutProblems(page), []);
    await page.click('[data-toggle=path]');
    assert.equal((await hook(page, 'pixels()')).hash, before.hash);
  });

  browserTest('brings the path of the camera into view after the view was turned, too', path, WINDOW, async (page) => {
    await page.focus('canvas');
    await page.keyboard.press('ArrowRight');
    for (let i = 0; i < 6; ++i) await page.keyboard.press('+');
    await drawn(page);
    const near = await hook(page, 'hash');
    await page.click('[data-toggle=path]');
    await drawn(page);
    const position = (hash) => new URLSearchParams(hash).get('camera').split(',').map(Number);
    const distance = ([x, y, z, u, v, w]) => Math.hypot(x - u, y - v, z - w);
    assert.ok(distance(position(await hook(page, 'hash'))) > 1.3 * distance(position(near)));
  });

  browserTest('compares the objects with the ground truth', path, WINDOW, async (page) => {
    assert.match(await page.textContent('.truth-section'), /2 of 4 objects found.*canObject 0, IoU [01]\.\d\d.*pan with cupObject \d, IoU 0\.[5-9].*barObject 7.*spoonnot seen/s);
    await hook(page, 'select(0)');
    assert.match(await page.textContent('.object.selected .details'), /Ground truthcan, IoU/);
    await hook(page, 'select(null)');
    const { hash } = await hook(page, 'pixels()');
    await page.click('[data-mode=truth]');
    assert.notEqual((await hook(page, 'pixels()')).hash, hash);
    assert.match(await hook(page, 'hash'), /mode=truth/);
  });

  browserTest('plays the sweep of the camera with its depth images', path, WINDOW, async (page) => {
    const image = () => page.evaluate(() => document.querySelector('.player .depth').toDataURL());
    const first = await image();
    await page.locator('.transport input').fill('3');
    assert.equal(await hook(page, 'moment'), 3);
    assert.notEqual(await image(), first);
    await page.click('.transport button');
    await page.waitForFunction(() => window.symscene.moment === 4);
    assert.equal(await hook(page, 'path'), true);
    await page.waitForSelector('.transport .icon-play');
    await hook(page, 'reset()');
    assert.equal(await image(), first);
  });

  browserTest('takes mesh and path from the address', path, WINDOW, async (page) => {
    assert.equal(await hook(page, 'mesh'), false);
    assert.equal(await hook(page, 'path'), true);
  }, { hash: '#mesh=0&path=1' });

  browserTest('has no overlapping elements on a phone', path, PHONE, async (page) => {
    assert.deepEqual(await layoutProblems(page), []);
  });
});

describe('a result with closed surfaces', () => {
  const path = () => pages.closed;

  browserTest('shows them in place of the points', path, WINDOW, async (page) => {
    const points = await hook(page, 'pixels()');
    await page.click('[data-toggle=completed]');
    const closed = await hook(page, 'pixels()');
    assert.notEqual(closed.hash, points.hash);
    assert.ok(closed.filled > 0.9 * points.filled, 'a closed surface covers what its points cover');
    await page.click('[data-toggle=completed]');
    assert.equal((await hook(page, 'pixels()')).hash, points.hash);
  });

  browserTest('selects the clicked object on its surface, and tells its volume', path, WINDOW, async (page) => {
    await page.click('[data-toggle=completed]');
    const { x, y } = await hook(page, 'clickPoint(2)');
    await page.mouse.click(x, y);
    assert.equal(await hook(page, 'selected'), 2);
    assert.match(await page.textContent('.object.selected .details'), /Volume412 cm³/);
    assert.deepEqual(await layoutProblems(page), []);
  });

  browserTest('draws the fitted surface of the selected object, and tells its dimensions', path, WINDOW, async (page) => {
    assert.deepEqual(await hook(page, 'shapes'), []);
    await page.evaluate('symscene.select(4)');
    assert.deepEqual(await hook(page, 'shapes'), [4]);
    assert.match(await page.textContent('.object.selected .details'), /Classbox.*Length20.00 ± 0.12 cm.*Height24.00 ± 0.12 cm/);
    await page.evaluate('symscene.select(0)');
    assert.match(await page.textContent('.object.selected .details'), /Classcylinder.*Radius3.70 ± 0.12 cm/);
    await page.evaluate('symscene.select(7)');
    assert.match(await page.textContent('.object.selected .details'), /Widthat least 7.0 cm \(an end is hidden\)/);
    assert.deepEqual(await layoutProblems(page), []);
  });
});

describe('a result with views', () => {
  const path = () => pages.views;

  browserTest('draws the views and marks the chosen one', path, WINDOW, async (page) => {
    assert.equal(await hook(page, 'views'), true);
    const rows = page.locator('.view-section [data-view-rank]');
    assert.deepEqual((await rows.allTextContents()).map((text) => text.replace(/\s+/g, ' ')),
      ['View 1040.0 cm²', 'View 1130.0 cm²', 'View 1220.0 cm²', 'View 1310.0 cm²']);
    const shown = await hook(page, 'pixels()');
    await rows.nth(2).click();
    await page.mouse.move(5, 500);
    assert.equal(await hook(page, 'chosenView'), 2);
    assert.match(await page.textContent('.view-section'), /View 12: inferred surface 20.0 cm²/);
    assert.notEqual((await hook(page, 'pixels()')).hash, shown.hash);
    await rows.nth(2).click();
    await page.mouse.move(5, 500);
    assert.equal((await hook(page, 'pixels()')).hash, shown.hash);
    await page.keyboard.press('n');
    assert.equal(await hook(page, 'views'), false);
    assert.notEqual((await hook(page, 'pixels()')).hash, shown.hash);
    assert.deepEqual(await layoutProblems(page), []);
  });
});

describe('a result with grasps', () => {
  const path = () => pages.grasps;
  const row = (id) => `.object:nth-child(${id + 1})`;

  browserTest('draws the gripper at the best grasp of every visible object', path, WINDOW, async (page) => {
    assert.equal(await pressed(page, '[data-toggle=grasps]'), 'true');
    const best = await hook(page, 'grasps');
    assert.equal(best.length, 4, 'the objects that are thin enough');
    const shown = await hook(page, 'pixels()');
    await page.keyboard.press('g');
    assert.deepEqual(await hook(page, 'grasps'), []);
    const without = await hook(page, 'pixels()');
    assert.ok(without.filled < shown.filled, 'grippers stand out above the objects');
    await page.click('[data-toggle=grasps]');
    assert.equal((await hook(page, 'pixels()')).hash, shown.hash);
    await page.click(`${row(0)} .eye`);
    assert.deepEqual(await hook(page, 'grasps'), best.slice(1));
  });

  browserTest('lists the grasps of an object, best first, and draws the chosen one', path, WINDOW, async (page) => {
    await page.click(`${row(0)} .pick`);
    const list = page.locator(`${row(0)} .object-grasps > .grasps .grasp`);
    const numbers = (await list.allTextContents()).map((text) => Number(text.slice(0, 4)));
    assert.deepEqual(numbers, [0.95, 0.5, 0.4, 0.3, 0.2]);
    assert.equal((await hook(page, 'grasps')).length, 5);
    const hashes = [(await hook(page, 'pixels()')).hash];
    for (const k of [1, 4]) {
      await list.nth(k).click();
      await page.mouse.move(5, 500);
      const key = await list.nth(k).getAttribute('data-grasp');
      assert.equal(await hook(page, 'grasp'), key);
      assert.equal(await list.nth(k).getAttribute('aria-pressed'), 'true');
      assert.equal((await hook(page, 'grasps')).at(-1), key, 'the chosen one is drawn last');
      hashes.push((await hook(page, 'pixels()')).hash);
    }
    assert.equal(new Set(hashes).size, 3);
    await list.nth(4).click();
    assert.equal(await hook(page, 'grasp'), null);
    assert.deepEqual(await layoutProblems(page), []);
  });

  browserTest('shows a rejected grasp with its reason and value', path, WINDOW, async (page) => {
    await page.click(`${row(0)} .pick`);
    assert.match(await page.textContent(`${row(0)} .object-grasps`), /Rejected, of 25 candidates.*Table.*14.*Other object.*6/s);
    await page.click(`${row(0)} .reason:has-text("Table") summary`);
    const rejected = page.locator(`${row(0)} [data-grasp^=r]`).first();
    assert.match(await rejected.textContent(), /-4\.0 mm < 2\.0 mm/);
    assert.ok((await hook(page, 'grasps')).every((key) => key.startsWith('a')));
    await rejected.click();
    assert.equal((await hook(page, 'grasps')).at(-1), await rejected.getAttribute('data-grasp'));
    assert.deepEqual(await layoutProblems(page), []);
  });

  browserTest('says why an object has no grasp', path, WINDOW, async (page) => {
    assert.match(await page.textContent(`${row(1)} .name`), /no grasp: too wide$/);
    await page.click(`${row(1)} .pick`);
    assert.deepEqual(await hook(page, 'grasps'), []);
    assert.match(await page.textContent(`${row(1)} .object-grasps h3`), /No grasp: too wide for the gripper/);
    assert.match(await page.textContent(`${row(1)} .object-grasps`), /210\.0 mm > 80\.0 mm/);
  });

  browserTest('shows the number of grasps in the row of an object, not cut off', path, WINDOW, async (page) => {
    assert.match(await page.textContent('.grasp-section'), /The best of each object is drawn/);
    const small = page.locator(`${row(0)} .name small`);
    assert.equal(await small.textContent(), '5 grasps');
    assert.ok(await small.evaluate((element) => element.scrollWidth <= element.clientWidth));
  });

  browserTest('counts the rejected candidates of all objects by reason', path, WINDOW, async (page) => {
    const text = await page.textContent('.grasp-section');
    assert.match(text, /4 of 8 objects.*Gripper panda, which opens 80 mm: 20 grasps of 128 candidates/s);
    assert.match(text, /The gripper would hit the table56.*Too wide for the gripper28.*another object24/s);
  });

  browserTest('takes the chosen grasp from the address', path, WINDOW, async (page) => {
    assert.equal(await hook(page, 'grasp'), 'r2');
    assert.notEqual(await hook(page, 'selected'), null);
    assert.equal((await hook(page, 'grasps')).at(-1), 'r2');
  }, { hash: '#grasp=r2' });

  browserTest('can leave the grasps out by the address, and ignores an unknown one', path, WINDOW, async (page) => {
    assert.deepEqual(await hook(page, 'grasps'), []);
    assert.equal(await hook(page, 'grasp'), null);
  }, { hash: '#grasps=0&grasp=a999' });

  browserTest('has nothing that covers another thing on a phone', path, PHONE, async (page) => {
    await hook(page, 'select(0)');
    assert.deepEqual(await layoutProblems(page), []);
  });

  browserTest('does not speak of drawn grasps where there is none', () => pages.noGrasps, WINDOW, async (page) => {
    const text = await page.textContent('.grasp-section');
    assert.match(text, /0 of 8 objects.*which opens 10 mm: 0 grasps of 56 candidates\./s);
    assert.doesNotMatch(text, /drawn/);
  });

  browserTest('draws three fingers', () => pages.threeFingers, WINDOW, async (page) => {
    assert.equal((await hook(page, 'grasps')).length, 7);
    const three = await hook(page, 'pixels()');
    await page.keyboard.press('g');
    assert.notEqual((await hook(page, 'pixels()')).hash, three.hash);
  });
});

describe('other results', () => {
  browserTest('shows hostile names as text', () => pages.hostile, DESKTOP, async (page) => {
    assert.equal(await page.textContent('h1'), HOSTILE);
    assert.equal(await page.title(), HOSTILE);
    assert.equal(await page.evaluate('window.hacked'), undefined);
    assert.equal(await page.locator('img').count(), 0);
    assert.equal(await page.locator('script').count(), 2);
    assert.deepEqual(await layoutProblems(page), []);
  });

  browserTest('lists the warnings', () => pages.hostile, WINDOW, async (page) => {
    assert.deepEqual(await page.locator('.warnings li').allTextContents(), [HOSTILE, 'no occupancy map']);
  });

  browserTest('reports that there is no object, with the reasons', () => pages.empty, WINDOW, async (page) => {
    assert.match(await page.textContent('.empty'), /No object was found/);
    assert.ok(await page.isVisible('.funnel'));
    assert.ok((await hook(page, 'pixels()')).filled > 0.05, 'the scan is still drawn');
  });

  browserTest('accepts a cloud without points', () => pages.noPoints, PHONE, async (page) => {
    assert.match(await page.textContent('.empty'), /no points/);
  });

  browserTest('shows the mesh of a bare table', () => pages.bare, WINDOW, async (page) => {
    assert.equal(await hook(page, 'mesh'), true);
    assert.ok((await hook(page, 'pixels()')).filled > 0.05, 'the mesh is drawn');
    assert.match(await page.textContent('.empty'), /Nothing stands on the table/);
    assert.match(await page.textContent('.panel'), /Camera: 1 frame\./);
  });

  browserTest('draws a page made by C++', () => process.env.SYMSCENE_PAGE, DESKTOP, async (page) => {
    const ids = await hook(page, 'visible');
    assert.equal(await hook(page, 'mesh'), true);
    assert.equal(await page.locator('[data-toggle=path]').count(), 1);
    assert.deepEqual(await hook(page, 'grasps'), ['a0', 'a1', 'a2']);
    assert.ok(ids.length > 0);
    const { x, y } = await hook(page, `clickPoint(${ids[0]})`);
    await page.mouse.click(x, y);
    assert.equal(await hook(page, 'selected'), ids[0]);
    assert.deepEqual(await layoutProblems(page), []);
  }, { skip: !process.env.SYMSCENE_PAGE });
});
