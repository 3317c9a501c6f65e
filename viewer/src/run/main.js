// Entry point of the page of a run: shows its events and what was left.
import { h } from '../dom.js';

const { title, events, left } = JSON.parse(document.getElementById('payload').textContent);
document.body.append(h('main', { class: 'run' }, h('h1', {}, title),
  h('ol', {}, events.map(({ time, text }) => h('li', {}, `${time.toFixed(1)} s: ${text}`))),
  h('ul', {}, left.map((reason) => h('li', {}, reason)))));
