// How many candidates passed each step, and the rejected hypotheses by reason.
import { h, setPressed } from '../dom.js';
import * as format from '../format.js';
import { createEffects } from './effects.js';

const MEANINGS = {
  symmetry: 'the points do not match their image under the symmetry',
  occlusion: 'the image lies in space that was observed to be empty',
  smoothness: 'the cut runs through a smooth surface',
  coverage: 'too small an angle about the axis was observed',
  perpendicularity: 'the normals are parallel to the axis',
  size: 'too few points',
  inlier: 'too few points have a correspondence',
  support: 'too little of the segment that proposed its symmetry is in it',
  overlap: 'shares too many points with objects that have greater scores together',
  score: 'too improbable that it is one whole object',
  composite: 'made up of other hypotheses',
  duplicate: 'nearly the same points as a better hypothesis',
  merged: 'nearly the same points as a better hypothesis',
};
const MOST_ROWS = 30;

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

// The hypotheses of each reason with their numbers; those that came nearest to their bound first.
function byReason(rejected) {
  const groups = new Map();
  rejected.forEach((entry, number) => {
    if (!groups.has(entry.reason)) groups.set(entry.reason, []);
    groups.get(entry.reason).push({ ...entry, number });
  });
  for (const entries of groups.values()) entries.sort((a, b) => Math.abs(a.value - a.bound) - Math.abs(b.value - b.bound) || b.size - a.size);
  return [...groups].sort((a, b) => b[1].length - a[1].length);
}

function rejectionRow({ kind, value, bound, size, points, number, effects }, actions) {
  const relation = value > bound ? '>' : value < bound ? '<' : '=';
  const button = h('button', {
    class: 'grasp', type: 'button', 'data-rejection': String(number), disabled: points.length === 0, 'aria-pressed': 'false',
    title: points.length ? 'Show it in the scene' : 'Its points are not known', onclick: () => actions.toggleRejection(number),
  }, h('span', { class: 'source' }, `${format.words(kind)}, ${format.plural(size, 'point')}`),
  h('span', { class: 'number' }, `${format.fixed(value, 3)} ${relation} ${format.fixed(bound, 3)}`));
  return h('li', {}, button, h('div', { class: 'rejection-effects', hidden: true }, createEffects(effects)));
}

function restText(entries) {
  const hidden = entries.slice(MOST_ROWS);
  if (hidden.length === 0) return null;
  const sizes = hidden.map(({ size }) => size);
  return `and ${format.count(hidden.length)} more that miss the bound by more, of ${format.count(Math.min(...sizes))} to ${format.plural(Math.max(...sizes), 'point')}`;
}

function reasonGroup([reason, entries], actions) {
  const rest = restText(entries);
  return h('details', { class: 'reason', 'data-reason': reason },
    h('summary', {}, h('span', {}, format.words(reason), h('small', {}, MEANINGS[reason] ?? '')),
      h('span', { class: 'aside' }, format.count(entries.length))),
    h('ul', { class: 'grasps' }, entries.slice(0, MOST_ROWS).map((entry) => rejectionRow(entry, actions))),
    rest && h('p', { class: 'more' }, rest));
}

// Marks the shown hypothesis; one that the address names opens its group.
function followRejection(element, store) {
  const buttons = [...element.querySelectorAll('[data-rejection]')];
  store.subscribe(({ rejection }, changed) => {
    if (!changed.has('rejection')) return;
    for (const button of buttons) {
      const isShown = button.dataset.rejection === String(rejection);
      setPressed(button, isShown);
      button.nextElementSibling.hidden = !isShown;
      if (isShown) for (const group of [button.closest('.reason'), element]) group.setAttribute('open', '');
    }
  });
}

export function createWhy({ funnel, rejected }, store, actions, open) {
  if (funnel.length === 0 && rejected.length === 0) return null;
  const element = h('details', { class: 'why-section', open },
    h('summary', {}, 'Why these objects', h('span', { class: 'aside' }, `${format.count(rejected.length)} rejected`)),
    createFunnel(funnel),
    rejected.length > 0 && h('h3', {}, 'Rejected hypotheses by reason; click one to see it'),
    byReason(rejected).map((group) => reasonGroup(group, actions)));
  followRejection(element, store);
  return element;
}
