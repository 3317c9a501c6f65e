// A headless Chromium with software WebGL and no network.
import { mkdtemp, rm } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const require = createRequire(new URL('../../viewer/package.json', import.meta.url));
const { chromium } = require('playwright-core');

const FLAGS = [
  '--no-sandbox', '--disable-gpu', '--use-gl=angle', '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--force-color-profile=srgb',
];

/** A browser with a fresh profile, and what closes it. `options` are Playwright's (viewport, colorScheme, ...). */
export async function launch(options) {
  const profile = await mkdtemp(join(tmpdir(), 'symscene-chromium-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    headless: true,
    args: FLAGS,
    reducedMotion: 'reduce',
    ...options,
  });
  const close = async () => {
    await context.close();
    await rm(profile, { recursive: true, force: true });
  };
  return { context, close };
}

/** Runs `body(context)` in a browser of its own. */
export async function withBrowser(options, body) {
  const { context, close } = await launch(options);
  try {
    return await body(context);
  } finally {
    await close();
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
