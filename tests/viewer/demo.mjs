// Writes a page of the synthetic tabletop: node demo.mjs [page.html]
import { tabletop } from './fixture.mjs';
import { writePage } from './payload.mjs';

const path = process.argv[2] ?? 'demo.html';
await writePage(path, tabletop());
console.log(path);
