// Writes pages of the synthetic tabletop and of a synthetic run: node demo.mjs [page.html [run.html]]
import { tabletop } from './fixture.mjs';
import { writePage } from './payload.mjs';
import { recordedRun } from './run_fixture.mjs';

const [path = 'demo.html', run = 'run_demo.html'] = process.argv.slice(2);
await writePage(path, tabletop({ cell: 0.005 }));
await writePage(run, recordedRun(), 'run.html');
console.log(`${path}\n${run}`);
