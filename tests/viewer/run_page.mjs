// The page of a run in a browser. SYMSCENE_RUN_PAGE and SYMSCENE_PLAN_PAGE are pages made by C++ (make_page) to test too.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe } from 'node:test';
import { browserTest } from './browser.mjs';
import { encodeRun, writePage } from './payload.mjs';
import { recordedRun } from './run_fixture.mjs';
import { box } from './run_meshes.mjs';

const WINDOW = { viewport: { width: 860, height: 400 } };
const DESKTOP = { viewport: { width: 1280, height: 800 } };
const SMALL = { viewport: { width: 700, height: 460 } };
const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };
const HOSTILE = '</title></script><script>window.hacked=1</script><img src=x onerror="window.hacked=1">';

let folder;
const pages = {};

/** A moment, an object of which no mesh is known, and texts that try to be markup. */
function hostileRun() {
  const pose = { position: [0, 0, 0], rotation: [0, 0, 0, 1] };
  return encodeRun({
    title: HOSTILE, times: [2], poses: [[pose, pose]], left: [HOSTILE],
    solids: [{ name: HOSTILE, kind: 'object', mesh: box([0.1, 0.1, 0.1]) }, { name: 'unknown', kind: 'object', mesh: null }],
    beliefs: [{ time: 2, objects: [{ name: HOSTILE, label: HOSTILE, mesh: null }] }],
    events: [{ time: 2, text: HOSTILE, outcome: 'failure' }],
  });
}

function emptyRun() {
  return encodeRun({
    title: 'Nothing', times: [], poses: [], beliefs: [], left: ['box: it was not looked at'], solids: [{ name: 'box', kind: 'object', mesh: box([0.1, 0.1, 0.1]) }],
    events: [{ time: 0, text: 'No view of the table is reachable', outcome: 'failure' }],
  });
}

before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'symscene-runs-'));
  for (const [name, run] of Object.entries({ run: recordedRun(), hostile: hostileRun(), nothing: emptyRun() })) {
    pages[name] = join(folder, `${name}.html`);
    await writePage(pages[name], run, 'run.html');
  }
});

after(async () => {
  await rm(folder, { recursive: true, force: true });
});

const runTest = (name, options, body, { path = () => pages.run, ...rest } = {}) => browserTest(name, path, options, body, rest);

const hook = (page, expression) => page.evaluate(`window.symscene.${expression}`);
const near = (a, b, message) => assert.ok(Math.abs(a - b) < 1e-6, message ?? `${a} is not ${b}`);

function layoutProblems(page) {
  return page.evaluate(() => {
    const shown = [...document.querySelectorAll('.panel, .player, .views-area, .caption, .group')].filter((e) => e.offsetParent !== null || e.matches('.player'));
    const boxes = shown.map((element) => ({ element, name: element.className, box: element.getBoundingClientRect() }));
    const problems = [];
    boxes.forEach(({ element, name, box: a }, i) => {
      if (a.left < -0.5 || a.top < -0.5 || a.right > innerWidth + 0.5 || a.bottom > innerHeight + 0.5) problems.push(`${name} leaves the window`);
      for (const other of boxes.slice(0, i)) {
        if (other.element.contains(element)) continue;
        const { box: b } = other;
        if (a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 0.5 && b.top < a.bottom - 0.5) problems.push(`${name} meets ${other.name}`);
      }
    });
    for (const element of document.querySelectorAll('.player .row, .scroll, .group')) {
      if (element.scrollWidth > element.clientWidth + 1) problems.push(`${element.className} overflows`);
    }
    return problems;
  });
}

describe('the page of a run', () => {
  runTest('tells what was picked and what was not, and lists the events', WINDOW, async (page) => {
    assert.equal(await page.textContent('.stats'), 'Picked 4 of 6 objects in 31 s · 1 failure');
    assert.deepEqual(await page.locator('.left li').allTextContents(),
      ['brick: every grasp within reach meets the crate', 'crate: too wide for the gripper, 160.0 mm > 80.0 mm']);
    assert.equal(await page.locator('.event').count(), 12);
    assert.equal(await page.locator('.event.is-success').count(), 4);
    assert.match(await page.textContent('.event.is-failure'), /0:10\.0Failure: The can slipped/);
    assert.equal(await page.locator('.at .is-success').count(), 4);
    assert.equal(await page.locator('.at .is-failure').count(), 1);
    assert.equal(await page.locator('.look').count(), 6);
  });

  runTest('chooses its detail by a frame that it measured', WINDOW, async (page) => {
    assert.ok((await hook(page, 'detail')).restDelay > 0);
  });

  runTest('draws both views, and other pixels in each', WINDOW, async (page) => {
    await hook(page, 'seek(8)');
    const [left, right] = await hook(page, 'pixels()');
    assert.deepEqual([left.side, right.side], ['true', 'believed']);
    for (const { filled } of [left, right]) assert.ok(filled > 0.05 && filled < 0.95, `${filled} is filled`);
    assert.notEqual(left.hash, right.hash);
    await page.click('[data-views=believed]');
    const single = await hook(page, 'pixels()');
    assert.deepEqual(single.map(({ side }) => side), ['believed']);
  });

  runTest('updates what the robot believes at each look, and not between', WINDOW, async (page) => {
    const believed = async (time) => { await hook(page, `seek(${time})`); return [await hook(page, 'belief'), await page.textContent('.captions')]; };
    assert.match((await believed(0))[1], /0 of 6 picked.*before the first look/);
    assert.equal((await believed(6.5))[0], 0);
    const [second, text] = await believed(6.7);
    assert.equal(second, 1);
    assert.match(text, /1 of 6 picked.*look 2 of 6, at 0:06\.6: 5 objects/);
    await hook(page, 'seek(3)');
    const tags = await hook(page, 'tags');
    assert.ok(tags.some((tag) => /^(box|cylinder) 0\.\d\d$/.test(tag)) && tags.includes('crate'), tags.join());
    await page.keyboard.press('l');
    await hook(page, 'pixels()');
    assert.deepEqual(await hook(page, 'tags'), []);
  });

  runTest('draws nothing while it rests, plays to the end and begins again', WINDOW, async (page) => {
    await page.waitForFunction(() => window.symscene.rested);
    const frames = await hook(page, 'frames');
    await page.waitForTimeout(400);
    assert.equal(await hook(page, 'frames'), frames);
    await hook(page, 'seek(29.5)');
    const before = await hook(page, 'pixels()');
    await page.selectOption('.speed', '4');
    await page.keyboard.press('Space');
    await page.waitForFunction(() => !window.symscene.playing);
    assert.ok(await hook(page, 'time') > 31);
    const after = await hook(page, 'pixels()');
    after.forEach(({ hash }, i) => assert.notEqual(hash, before[i].hash));
    await page.click('[aria-label=Play]');
    await page.waitForFunction(() => window.symscene.playing && window.symscene.time < 20);
    await page.click('[aria-label=Pause]');
    assert.equal(await hook(page, 'playing'), false);
  });

  runTest('obeys the keys', WINDOW, async (page) => {
    const times = [];
    for (const key of ['ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowLeft', 'Shift+ArrowRight', 'Shift+ArrowLeft', 'End', 'ArrowLeft', 'Home']) {
      await page.keyboard.press(key);
      times.push(await hook(page, 'time'));
    }
    [0.1, 5.6, 6.6, 5.6, 6.6, 5.6, 31.4, 30.5, 0].forEach((time, i) => near(times[i], time, `step ${i}: ${times[i]}`));
    for (const [key, speed] of [[']', 2], [']', 4], ['[', 2]]) {
      await page.keyboard.press(key);
      assert.equal(await hook(page, 'speed'), speed);
    }
    for (const views of ['true', 'believed', 'both']) {
      await page.keyboard.press('b');
      assert.equal(await hook(page, 'views'), views);
    }
    await page.keyboard.press('Space');
    assert.equal(await hook(page, 'playing'), true);
    await page.keyboard.press('Space');
    assert.equal(await hook(page, 'playing'), false);
  });

  runTest('goes to a clicked event, and space plays after the click', WINDOW, async (page) => {
    await page.click('.event.is-failure');
    near(await hook(page, 'time'), 10);
    assert.equal(await page.getAttribute('.event.is-failure', 'aria-current'), 'true');
    assert.match(await page.textContent('.now'), /The can slipped/);
    await page.click('.at:has(.is-success) >> nth=1');
    near(await hook(page, 'time'), 16.5);
    await page.keyboard.press('Space');
    assert.equal(await hook(page, 'playing'), true);
  });

  runTest('is moved by the slider, by mouse and keys', WINDOW, async (page) => {
    const slider = await page.locator('.slider').boundingBox();
    await page.mouse.click(slider.x + slider.width / 2, slider.y + slider.height / 2);
    assert.ok(Math.abs(await hook(page, 'time') - 15.7) < 0.5);
    await page.keyboard.press('ArrowRight');
    near(await hook(page, 'time'), 16.5, 'after a click the arrows go to events');
    await page.focus('.slider');
    await page.keyboard.press('ArrowRight');
    near(await hook(page, 'time'), 16.5 + 0.314);
    assert.match(await page.getAttribute('.slider', 'aria-valuetext'), /^0:16\.8 of 0:31\.4$/);
  });

  runTest('takes time, speed and view from the address, and writes the time there', WINDOW, async (page) => {
    near(await hook(page, 'time'), 12.3);
    assert.equal(await hook(page, 'speed'), 2);
    assert.equal(await hook(page, 'views'), 'believed');
    await page.keyboard.press('End');
    await page.waitForFunction(() => location.hash.includes('t=31.40'));
    assert.match(await page.evaluate('location.hash'), /show=believed/);
    await page.evaluate(() => { location.hash = '#t=4'; });
    await page.waitForFunction(() => window.symscene.time === 4);
    // A new address stays where the page was about to write its own.
    await page.evaluate(() => {
      window.symscene.seek(20);
      const end = performance.now() + 300;
      while (performance.now() < end); // the page's own is due now
      location.hash = '#t=5';
    });
    await page.waitForFunction(() => window.symscene.time === 5);
  }, { hash: '#t=12.3&show=believed&speed=2&view=top', isFresh: true });

  runTest('ignores an address that makes no sense', WINDOW, async (page) => {
    assert.equal(await hook(page, 'time'), 0);
    assert.equal(await hook(page, 'speed'), 1);
    assert.equal(await hook(page, 'views'), 'both');
  }, { hash: '#t=soon&speed=99&show=none&view=inside' });

  runTest('saves a video that plays', WINDOW, async (page, context) => {
    await hook(page, 'seek(2)');
    await page.click('.record');
    await page.waitForFunction(() => window.symscene.recording && window.symscene.time > 3);
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('.record')]);
    assert.equal(download.suggestedFilename(), 'Panda-clears-a-table.webm');
    assert.equal(await hook(page, 'playing'), false);
    const path = join(folder, 'run.webm');
    await download.saveAs(path);
    const data = `data:video/webm;base64,${(await readFile(path)).toString('base64')}`;
    const watcher = await context.newPage();
    const size = await watcher.evaluate(async (source) => {
      const video = document.createElement('video');
      video.src = source;
      await new Promise((resolve, reject) => { video.onloadeddata = resolve; video.onerror = reject; });
      return [video.videoWidth, video.videoHeight];
    }, data);
    await watcher.close();
    const [width, height] = await page.evaluate(() => { const { clientWidth: w, clientHeight: h } = document.querySelector('canvas'); return [w, h]; });
    assert.ok(Math.abs(size[0] - width) <= 1 && size[1] > height, `${size} for a canvas of ${width} × ${height}`);
  });

  runTest('has a name for every control', WINDOW, async (page) => {
    const unnamed = await page.evaluate(() => [...document.querySelectorAll('button, input, select')]
      .filter((e) => !e.closest('[aria-hidden=true]') && !(e.getAttribute('aria-label') || e.textContent.trim())).map((e) => e.outerHTML));
    assert.deepEqual(unnamed, []);
  });

  for (const [name, options] of [['desktop', DESKTOP], ['window', WINDOW], ['small window', SMALL], ['phone', PHONE]]) {
    runTest(`has nothing that covers another thing: ${name}`, options, async (page) => {
      assert.deepEqual(await layoutProblems(page), []);
    });
  }

  runTest('has one view with a switch on a phone', PHONE, async (page) => {
    assert.equal(await hook(page, 'views'), 'true');
    assert.equal(await page.isVisible('[data-views=both]'), false);
    await hook(page, 'seek(8)');
    const [{ hash }] = await hook(page, 'pixels()');
    await page.tap('[data-views=believed]');
    const drawn = await hook(page, 'pixels()');
    assert.deepEqual(drawn.map(({ side }) => side), ['believed']);
    assert.notEqual(drawn[0].hash, hash);
  });

  runTest('shows hostile names as text, and a run of one moment', DESKTOP, async (page) => {
    assert.equal(await page.textContent('h1'), HOSTILE);
    assert.equal(await page.evaluate('window.hacked'), undefined);
    assert.equal(await page.locator('img').count(), 0);
    await page.keyboard.press('Space');
    assert.equal(await hook(page, 'playing'), false, 'there is nothing to play');
    assert.equal(await page.textContent('.stats'), 'Picked 1 of 2 objects in 0.0 s · 1 failure');
  }, { path: () => pages.hostile });

  runTest('shows the events of a run that never began', WINDOW, async (page) => {
    assert.equal(await page.textContent('.stats'), 'Picked 0 of 1 object in 0.0 s · 1 failure');
    assert.match(await page.textContent('.event'), /No view of the table is reachable/);
    await page.keyboard.press('ArrowRight');
    assert.equal(await hook(page, 'time'), 0);
  }, { path: () => pages.nothing });

  runTest('plays a run made by C++', WINDOW, async (page) => {
    assert.equal(await page.textContent('.stats'), 'Picked 1 of 2 objects in 4.0 s · 1 failure');
    const hashes = [];
    for (const time of [0.5, 2, 3]) {
      await hook(page, `seek(${time})`);
      hashes.push((await hook(page, 'pixels()'))[0].hash);
    }
    assert.equal(new Set(hashes).size, 3, 'the arm moves');
    assert.ok((await hook(page, 'tags')).includes('box 0.93'));
  }, { path: () => process.env.SYMSCENE_RUN_PAGE, skip: !process.env.SYMSCENE_RUN_PAGE });

  runTest('of a plan lists why grasps are not reached, and draws maps, motion and the chosen hand', WINDOW, async (page) => {
    assert.equal(await page.textContent('.stats'), '2 of 4 grasps reached · 1 not reached · 1 not tried');
    assert.match(await page.textContent('.planned.is-not_reached'), /Grasp 3 of object 0.*not reached.*a joint would leave its limits/);
    assert.equal(await page.locator('.left, .choice').count(), 0, 'there are no beliefs');
    assert.equal(await hook(page, 'views'), 'true');
    assert.deepEqual(await layoutProblems(page), []);
    const drawn = async () => (await hook(page, 'pixels()'))[0].hash;
    const hashes = [await drawn()];
    for (const map of ['side', 'off']) {
      await page.click(`[data-map=${map}]`);
      hashes.push(await drawn());
    }
    await page.click('[data-grasp="1"]');
    assert.equal(await hook(page, 'grasp'), 1);
    hashes.push(await drawn());
    await hook(page, 'seek(2)');
    hashes.push(await drawn());
    assert.equal(new Set(hashes).size, 5);
  }, { path: () => process.env.SYMSCENE_PLAN_PAGE, skip: !process.env.SYMSCENE_PLAN_PAGE });
});
