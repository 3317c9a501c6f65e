// A headless Chromium with software WebGL and no network.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';

const require = createRequire(new URL('../../viewer/package.json', import.meta.url));
const { chromium } = require('playwright-core');

const FLAGS = [
  '--no-sandbox', '--disable-gpu', '--use-gl=angle', '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--force-color-profile=srgb',
];

let started;

/** One browser for all tests: to start it takes longer than most of them. */
function browser() {
  started ??= chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true, args: FLAGS });
  return started;
}

after(async () => (await started)?.close());

/** Opens a page file and waits for its first picture; `trouble` collects errors and requests. */
async function openPage(context, path, hash) {
  const page = await context.newPage();
  const trouble = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !/GPU stall|software WebGL/i.test(message.text())) {
      trouble.push(`${message.type()}: ${message.text()}`);
    }
  });
  page.on('pageerror', (error) => trouble.push(`uncaught: ${error.stack}`));
  page.on('request', (request) => {
    if (!/^(file|data):/.test(request.url())) trouble.push(`request: ${request.url()}`);
  });
  await page.goto(`${pathToFileURL(resolve(path))}${hash}`);
  await page.waitForFunction(() => window.symscene, null, { timeout: 60000 })
    .catch(() => trouble.push('window.symscene never came'));
  if (trouble.length === 0) await page.evaluate(() => window.symscene.ready);
  return { page, trouble };
}

async function openContext(path, options, hash) {
  const context = await (await browser()).newContext({ reducedMotion: 'reduce', ...options });
  return { context, ...await openPage(context, path, hash) };
}

/** Waits until the picture shows the state. */
export const drawn = (page) => page.waitForFunction(() => window.symscene.drawn);

/** Sets an opened page back to how it begins, in the window and the colours of `options`. */
async function reset({ page }, { viewport, colorScheme = 'light', hasTouch }) {
  await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
  await page.setViewportSize(viewport);
  if (!hasTouch) await page.mouse.move(1, viewport.height / 2);
  await page.evaluate(async () => {
    document.activeElement?.blur();
    await new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); }); // the new size is observed
    window.symscene.reset();
  });
  await drawn(page);
}

// To load a page and compile its shaders without a graphics card takes longer than most tests. The last page stays open
// for the next test of the same file on the same kind of screen.
let last = null;

async function closeLast() {
  await last?.context.close();
  last = null;
}

after(closeLast);

async function openLast(path, options) {
  const key = JSON.stringify([path, Boolean(options.isMobile), Boolean(options.acceptDownloads)]);
  if (last?.key === key) {
    await reset(last, options);
    return;
  }
  await closeLast();
  last = { key, ...await openContext(path, options, '') };
}

/**
 * A browser test: `body(page, context)` with the page of the file path(). It fails if the page logs an error or warning, or
 * requests the network. `options` are Playwright's (viewport, colorScheme, ...). A test with a `hash`, or that is `alone`, has
 * a context of its own, which shares nothing with others; the rest may share a page, which is set back between them.
 */
export function browserTest(name, path, options, body, { hash = '', alone = hash !== '', skip = false } = {}) {
  test(name, { timeout: 120000, skip }, async () => {
    const opened = alone ? await openContext(path(), options, hash) : await openLast(path(), options).then(() => last);
    let passed = false;
    try {
      assert.deepEqual(opened.trouble, []);
      await body(opened.page, opened.context);
      assert.deepEqual(opened.trouble, []);
      passed = true;
    } finally {
      if (alone) await opened.context.close();
      else if (!passed) await closeLast();
    }
  });
}
