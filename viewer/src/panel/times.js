// Wall time by stage, as bars.
import { h } from '../dom.js';
import * as format from '../format.js';

export const totalTime = (timings) => timings.reduce((sum, { seconds }) => sum + (seconds || 0), 0);

function bar({ stage, seconds }, longest) {
  return h('tr', {},
    h('th', { scope: 'row' }, format.words(stage)),
    h('td', { class: 'bar' }, h('span', { style: { width: `${(100 * (seconds || 0)) / longest}%` } })),
    h('td', { class: 'number' }, format.seconds(seconds)));
}

export function createTimes(timings) {
  if (timings.length === 0) return null;
  const longest = Math.max(...timings.map(({ seconds }) => seconds || 0), 1e-9);
  return h('details', { class: 'times', open: true },
    h('summary', {}, 'Time by stage', h('span', { class: 'aside' }, format.seconds(totalTime(timings)))),
    h('table', { class: 'bars' }, h('tbody', {}, timings.map((entry) => bar(entry, longest)))));
}
