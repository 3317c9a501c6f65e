// The page of an exploration in a browser. SYMSCENE_EXPLORATION_PAGE is a page made by C++ (make_page) to test too.
import assert from 'node:assert/strict';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { depthPixels } from '../../viewer/src/depth_image.js';
import { chartPoint, decodeExploration, knownText } from '../../viewer/src/run/explore.js';
import { browserTest } from './browser.mjs';
import { exploredBoxes } from './explore_fixture.mjs';
import { writePage } from './payload.mjs';

const WINDOW = { viewport: { width: 1000, height: 560 } };
const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };
const HOSTILE = '</title></script><script>window.hacked=1</script><img src=x onerror="window.hacked=1">';

let folder;
const pages = {};

before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'symscene-exploration-'));
  const hostile = exploredBoxes({ title: HOSTILE });
  hostile.left = [HOSTILE];
  hostile.exploration.end = HOSTILE;
  for (const [name, payload] of Object.entries({ explored: exploredBoxes(), unranked: exploredBoxes({ ranked: false }), hostile })) {
    pages[name] = join(folder, `${name}.html`);
    await writePage(pages[name], payload, 'run.html');
  }
});

after(() => rm(folder, { recursive: true, force: true }));

const exploreTest = (name, body, { options = WINDOW, path = () => pages.explored, ...rest } = {}) =>
  browserTest(name, path, options, body, rest);

const hook = (page, expression) => page.evaluate(`window.symscene.${expression}`);
const hashes = async (page) => (await hook(page, 'pixels()')).map(({ hash }) => hash);

/** Parts that leave the window, and rows that overflow. */
const layoutProblems = (page) => page.evaluate(() => {
  const outside = [...document.querySelectorAll('.panel, .player, .views-area')].filter((element) => {
    const box = element.getBoundingClientRect();
    return box.left < -0.5 || box.top < -0.5 || box.right > innerWidth + 0.5 || box.bottom > innerHeight + 0.5;
  });
  const overflowing = [...document.querySelectorAll('.scroll, .taken, .candidates')].filter((element) => element.scrollWidth > element.clientWidth + 1);
  return [...outside, ...overflowing].map((element) => element.className);
});

describe('the page of an exploration', () => {
  exploreTest('tells how much is known at the end, and what is left unknown', async (page) => {
    assert.equal(await page.textContent('.stats'), '3 views · 2 objects · 93 % seen, 97 % completed');
    assert.deepEqual(await page.locator('.left li').allTextContents(), ['3 % of the surface of 2 known objects (12 cm²) is inferred, not seen']);
    assert.match(await page.textContent('.coverage'), /ended because no further view is expected/);
    assert.equal(await page.getAttribute('.chart', 'aria-label'), 'After 3 views: 93 % seen, 97 % completed');
    assert.equal(await page.locator('.chart .dot').count(), 6);
  });

  exploreTest('goes from view to view with the keys: objects, candidates and depth image follow', async (page) => {
    const numbers = () => page.locator('[data-candidate]').evaluateAll((all) => all.map(({ dataset }) => Number(dataset.candidate)));
    assert.deepEqual(await numbers(), [2, 1, 4]);
    assert.match(await page.textContent('.taken'), /View 1 of 3, candidate 0.*chosen without a ranking.*1 object, 41 % seen, 62 % completed/);
    assert.match(await page.textContent('[data-candidate="2"]'), /taken next.*31\.5 cm²/);
    assert.match(await page.textContent('.captions'), /41 % seen.*after view 1 of 3: 1 object/);
    const first = await hashes(page);
    await page.keyboard.press('ArrowRight');
    assert.equal(await hook(page, 'time'), 2);
    assert.deepEqual(await numbers(), [4, 1]);
    assert.match(await page.textContent('.taken'), /View 2 of 3, candidate 2.*expected gain 31\.5 cm².*2 objects/);
    (await hashes(page)).forEach((hash, side) => assert.notEqual(hash, first[side]));
    await page.keyboard.press('End');
    assert.match(await page.textContent('.captions'), /93 % seen.*after view 3 of 3: 2 objects/);
    assert.equal(await page.locator('.candidate small').count(), 0, 'none is taken next');
  });

  exploreTest('draws the chosen candidate strongly, and goes to a clicked point of the curve', async (page) => {
    const before = await hashes(page);
    await page.click('[data-candidate="1"]');
    assert.equal(await hook(page, 'candidate'), 1);
    assert.equal(await page.getAttribute('[data-candidate="1"]', 'aria-pressed'), 'true');
    (await hashes(page)).forEach((hash, side) => assert.notEqual(hash, before[side]));
    await page.click('[data-candidate="1"]');
    assert.deepEqual(await hashes(page), before);
    await page.click('.dot.is-completed >> nth=2');
    assert.equal(await hook(page, 'time'), 4);
  });

  exploreTest('draws the depth image, bright where it is near', async (page) => {
    const pixels = await page.evaluate(() => {
      const canvas = document.querySelector('.depth');
      return [canvas.width, canvas.height, ...canvas.getContext('2d').getImageData(0, 0, 3, 1).data];
    });
    assert.deepEqual(pixels, [16, 12, 42, 26, 62, 255, 2, 2, 2, 255, 3, 3, 3, 255]);
  });

  exploreTest('plays', async (page) => {
    await page.selectOption('.speed', '8');
    await page.keyboard.press('Space');
    await page.waitForFunction(() => !window.symscene.playing && window.symscene.time === 4);
    assert.match(await page.textContent('.taken'), /View 3 of 3/);
  });

  for (const [name, options] of [['window', WINDOW], ['phone', PHONE]]) {
    exploreTest(`has nothing that leaves its place: ${name}`, async (page) => assert.deepEqual(await layoutProblems(page), []), { options });
  }

  exploreTest('says that a policy ranks no views', async (page) => {
    assert.equal(await page.locator('[data-candidate]').count(), 0);
    assert.match(await page.textContent('.candidates'), /The policy ranks no views/);
    await page.keyboard.press('ArrowRight');
    assert.match(await page.textContent('.taken'), /chosen without a ranking/);
  }, { path: () => pages.unranked });

  exploreTest('shows hostile names as text', async (page) => {
    assert.equal(await page.textContent('h1'), HOSTILE);
    assert.equal(await page.evaluate('window.hacked'), undefined);
    assert.equal(await page.locator('img').count(), 0);
  }, { path: () => pages.hostile });

  exploreTest('plays an exploration made by C++', async (page) => {
    assert.equal(await page.textContent('.stats'), '2 views · 1 object · 75 % seen, 88 % completed');
    const first = await hashes(page);
    await page.keyboard.press('ArrowRight');
    (await hashes(page)).forEach((hash, side) => assert.notEqual(hash, first[side]));
  }, { path: () => process.env.SYMSCENE_EXPLORATION_PAGE, skip: !process.env.SYMSCENE_EXPLORATION_PAGE });
});

test('a chart keeps its points between its edges, and a lone view at the left', () => {
  const size = { width: 100, height: 50 };
  assert.deepEqual(chartPoint(0, 0.5, 1, size), [0, 25]);
  assert.deepEqual(chartPoint(3, 1.2, 4, size), [100, 0]);
  assert.deepEqual(chartPoint(1, -1, 3, size), [50, 50]);
});

test('before the first view the page tells of the first', () => {
  const exploration = decodeExploration(exploredBoxes().exploration);
  assert.equal(knownText(exploration, -5), 'after view 1 of 3: 1 object');
  assert.equal(exploration.stepAt(3.9), 1);
  assert.equal(decodeExploration(undefined), null);
});

test('every pixel of a depth image is opaque, and unmeasured ones have a colour of their own', () => {
  const pixels = depthPixels({ nearness: Uint8Array.of(0, 1, 255) });
  assert.deepEqual([...pixels], [42, 26, 62, 255, 1, 1, 1, 255, 255, 255, 255, 255]);
});
