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

// A page of a context of its own; `trouble` collects errors and requests, except those to `server`.
async function openContext({ server, ...options }) {
  const context = await (await browser()).newContext({ reducedMotion: 'reduce', ...options });
  const page = await context.newPage();
  const trouble = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !/GPU stall|software WebGL/i.test(message.text())) {
      trouble.push(`${message.type()}: ${message.text()}`);
    }
  });
  page.on('pageerror', (error) => trouble.push(`uncaught: ${error.stack}`));
  page.on('request', (request) => {
    const isExpected = /^(file|data):/.test(request.url()) || (server && request.url().startsWith(server));
    if (!isExpected) trouble.push(`request: ${request.url()}`);
  });
  return { context, page, trouble };
}

/** Loads a page file and waits for its first picture. */
async function load({ page, trouble }, path, hash = '') {
  await page.goto(`${pathToFileURL(resolve(path))}${hash}`);
  await page.waitForFunction(() => window.symscene, null, { timeout: 60000 })
    .catch(() => trouble.push('window.symscene never came'));
  if (trouble.length === 0) await page.evaluate(() => window.symscene.ready);
}

/** Waits until the picture shows the state. */
export const drawn = (page) => page.waitForFunction(() => window.symscene.drawn);

/** Sets window, colours and mouse as in a new context with these options. */
async function fit({ page }, { viewport, colorScheme = 'light', hasTouch }) {
  await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
  await page.setViewportSize(viewport);
  if (!hasTouch) await page.mouse.move(1, viewport.height / 2);
}

/** Sets a loaded page back to how it begins. */
async function reset({ page }) {
  await page.evaluate(async () => {
    document.activeElement?.blur();
    history.replaceState(null, '', location.pathname);
    await new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); }); // the new size is observed
    window.symscene.reset();
  });
  await drawn(page);
}

// To load a page and compile its shaders without a graphics card takes longer than most tests. The last page stays for the
// next test on the same kind of screen.
let last = null;

async function closeLast() {
  await last?.context.close();
  last = null;
}

after(closeLast);

async function openLast(path, options, isFresh) {
  const screen = Boolean(options.isMobile);
  if (last?.screen !== screen) {
    await closeLast();
    last = { path: null, screen, ...await openContext(options) };
  }
  await fit(last, options);
  if (last.path === path && !isFresh) await reset(last);
  else await load(last, path);
  last.path = path;
  return last;
}

/** Changes the hash of the address, which the page follows. */
async function follow({ page }, hash) {
  await page.evaluate((text) => new Promise((resolve) => {
    addEventListener('hashchange', resolve, { once: true });
    location.hash = text;
  }), hash);
  await drawn(page);
}

async function openAlone(path, options, hash) {
  const opened = await openContext(options);
  await load(opened, path, hash);
  return opened;
}

/**
 * A browser test: `body(page, context)` with the page of the file path(). It fails if the page logs an error or warning, or
 * requests the network. `options` are Playwright's (viewport, colorScheme, ...). One that `isFresh` loads the page, with its
 * `hash` in a context of its own. Others may get the page of the test before, which is set back and then follows the `hash`.
 */
export function browserTest(name, path, options, body, { hash = '', isFresh = false, skip = false } = {}) {
  test(name, { timeout: 120000, skip }, async () => {
    const isAlone = isFresh && hash !== '';
    const opened = await (isAlone ? openAlone(path(), options, hash) : openLast(path(), options, isFresh));
    if (hash && !isAlone) await follow(opened, hash);
    let passed = false;
    try {
      assert.deepEqual(opened.trouble, []);
      await body(opened.page, opened.context);
      assert.deepEqual(opened.trouble, []);
      passed = true;
    } finally {
      if (isAlone) await opened.context.close();
      else if (!passed) await closeLast();
    }
  });
}

/** A test of a page that its server sends: `body(page, trouble)` opens it. No other server may be asked. */
export function servedTest(name, server, options, body, { skip = false } = {}) {
  test(name, { timeout: 120000, skip }, async () => {
    const { context, page, trouble } = await openContext({ server: await server(), ...options });
    try {
      await body(page, trouble);
    } finally {
      await context.close();
    }
  });
}
