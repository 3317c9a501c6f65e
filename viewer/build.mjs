// Bundles the pages into dist/page.html, dist/review.html, dist/run.html and dist/live.html: files with two placeholders, for title and payload.
import { build } from 'esbuild';
import { mkdir, readFile, writeFile } from 'node:fs/promises';

const here = (name) => new URL(name, import.meta.url);

async function bundle(entry) {
  const result = await build({
    entryPoints: [here(entry).pathname],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: ['es2020', 'chrome90', 'firefox90', 'safari15'],
    legalComments: 'none',
    logLevel: 'warning',
  });
  return result.outputFiles[0].text.trim();
}

const template = await readFile(here('template.html'), 'utf8');
// The licence of what is bundled goes where the bundle goes.
const licence = (await readFile(here('node_modules/three/LICENSE'), 'utf8')).trim();

/** `connects`: the page asks the server that it comes from, and no other. */
async function makePage(name, styleEntry, scriptEntry, { connects = false } = {}) {
  const [style, script] = await Promise.all([bundle(styleEntry), bundle(scriptEntry)]);
  // Replacement functions, because "$&" in a bundle must stay what it is.
  const page = template
    .replace('/*@@STYLE@@*/', () => style)
    .replace('/*@@SCRIPT@@*/', () => `/*! three.js, https://threejs.org\n\n${licence}\n*/\n${script}`);
  const policy = "default-src 'none';";
  if (page.split(policy).length !== 2) throw new Error(`${policy} must occur once`);
  const allowed = connects ? page.replace(policy, `${policy} connect-src 'self';`) : page;
  for (const placeholder of ['@@SYMSCENE_TITLE@@', '"@@SYMSCENE_PAYLOAD@@"']) {
    if (page.split(placeholder).length !== 2) throw new Error(`${placeholder} must occur once`);
  }
  await writeFile(here(`dist/${name}`), allowed);
  console.log(`dist/${name}  ${(page.length / 1024).toFixed(0)} KiB`);
}

await mkdir(here('dist/'), { recursive: true });
await makePage('page.html', 'src/style.css', 'src/main.js');
await makePage('review.html', 'src/review/review.css', 'src/review/main.js');
await makePage('run.html', 'src/run/run.css', 'src/run/main.js');
await makePage('live.html', 'src/live/live.css', 'src/live/main.js', { connects: true });
