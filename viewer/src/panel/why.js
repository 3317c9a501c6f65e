// How many candidates passed each step, and the rejected hypotheses by reason.
import { h } from '../dom.js';
import * as format from '../format.js';

const MEANINGS = {
  symmetry: 'the points do not match their image under the symmetry',
  occlusion: 'the image lies in space that was observed to be empty',
  smoothness: 'the cut runs through a smooth surface',
  coverage: 'too small an angle about the axis was observed',
  perpendicularity: 'the normals are parallel to the axis',
  size: 'too few points',
  inlier: 'too few points have a correspondence',
  support: 'too little overlap with the segment that proposed it',
  overlap: 'too little overlap with the segment that proposed it',
  duplicate: 'nearly the same points as a better hypothesis',
  merged: 'nearly the same points as a better hypothesis',
};
const MOST_ROWS = 60;

// In "rotational: distinct axes" the part before the colon is the stream, shown on its own line.
function splitStep(step) {
  const [, stream, rest] = /^([^:]+): (.+)$/s.exec(step) ?? [null, '', step];
  return { stream, name: rest };
}

function funnelRow({ step, count }, most) {
  // Counts fall by orders of magnitude: the bars are logarithmic.
  const share = Math.log1p(count) / Math.log1p(most);
  return h('tr', {},
    h('th', { scope: 'row' }, format.words(splitStep(step).name)),
    h('td', { class: 'bar' }, h('span', { style: { width: `${100 * share}%` } })),
    h('td', { class: 'number' }, format.count(count)));
}

function createFunnel(funnel) {
  if (funnel.length === 0) return null;
  const most = Math.max(1, ...funnel.map(({ count }) => count));
  const rows = funnel.flatMap((entry, i) => {
    const { stream } = splitStep(entry.step);
    const isNew = stream !== (i ? splitStep(funnel[i - 1].step).stream : '');
    const head = isNew && h('tr', { class: 'stream' }, h('th', { colspan: '3', scope: 'colgroup' }, format.words(stream)));
    return [head, funnelRow(entry, most)];
  });
  return h('div', { class: 'funnel' },
    h('h3', {}, 'Candidates left after each step (log scale)'),
    h('table', { class: 'bars' }, h('tbody', {}, rows)));
}

function byReason(rejected) {
  const groups = new Map();
  for (const entry of rejected) {
    if (!groups.has(entry.reason)) groups.set(entry.reason, []);
    groups.get(entry.reason).push(entry);
  }
  return [...groups].sort((a, b) => b[1].length - a[1].length);
}

function rejection({ kind, value, bound, size }) {
  const relation = value > bound ? '>' : value < bound ? '<' : '=';
  return h('tr', {},
    h('th', { scope: 'row' }, format.words(kind)),
    h('td', { class: 'number' }, `${format.fixed(value, 3)} ${relation} ${format.fixed(bound, 3)}`),
    h('td', { class: 'number' }, format.plural(size, 'point')));
}

function reasonGroup([reason, entries]) {
  const hidden = entries.length - MOST_ROWS;
  return h('details', { class: 'reason' },
    h('summary', {}, h('span', {}, format.words(reason), h('small', {}, MEANINGS[reason] ?? '')),
      h('span', { class: 'aside' }, format.count(entries.length))),
    h('table', { class: 'refusals' }, h('tbody', {}, entries.slice(0, MOST_ROWS).map(rejection))),
    hidden > 0 && h('p', { class: 'more' }, `and ${format.count(hidden)} more`));
}

export function createWhy({ funnel, rejected }, open) {
  if (funnel.length === 0 && rejected.length === 0) return null;
  return h('details', { class: 'why-section', open },
    h('summary', {}, 'Why these objects', h('span', { class: 'aside' }, `${format.count(rejected.length)} rejected`)),
    createFunnel(funnel),
    rejected.length > 0 && h('h3', {}, 'Rejected hypotheses by reason'),
    byReason(rejected).map(reasonGroup));
}
