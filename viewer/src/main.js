// Entry point: decodes the payload, builds scene and controls, and draws on demand.
import { createApp } from './app.js';
import { h } from './dom.js';
import { decodePayload } from './payload.js';
import { moveToTableFrame } from './frame.js';

function fail(error) {
  document.body.append(h('div', { class: 'failure', role: 'alert' },
    h('strong', {}, 'The scene cannot be drawn.'),
    h('p', {}, String(error?.message ?? error)),
    h('p', {}, 'A browser with WebGL 2 is needed.')));
}

try {
  const payload = JSON.parse(document.getElementById('payload').textContent);
  createApp(moveToTableFrame(decodePayload(payload)));
} catch (error) {
  fail(error);
  throw error;
}
