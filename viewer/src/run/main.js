// Entry point of the page of a run: decodes the payload and builds views and player.
import { h } from '../dom.js';
import { createApp } from './app.js';
import { decodeRecording } from './recording.js';

try {
  createApp(decodeRecording(JSON.parse(document.getElementById('payload').textContent)));
} catch (error) {
  document.body.append(h('div', { class: 'failure', role: 'alert' },
    h('strong', {}, 'The run cannot be drawn.'), h('p', {}, String(error?.message ?? error)),
    h('p', {}, 'A browser with WebGL 2 is needed.')));
  throw error;
}
