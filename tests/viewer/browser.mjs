// A headless Chromium with software WebGL and no network.
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { after } from 'node:test';
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

/** Runs `body(context)` in a context of its own, which shares nothing with others. `options` are Playwright's (viewport, colorScheme, ...). */
export async function withBrowser(options, body) {
  const context = await (await browser()).newContext({ reducedMotion: 'reduce', ...options });
  try {
    return await body(context);
  } finally {
    await context.close();
  }
}

/** Opens a page file and waits for its first picture; `trouble` collects errors and requests. */
export async function openPage(context, path, hash = '') {
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
