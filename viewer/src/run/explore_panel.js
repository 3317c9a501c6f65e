// The parts of the panel that only an exploration has: the view that was taken last with its depth image, the views that
// could follow, and how much is known after each view.
import { drawDepth } from '../depth_image.js';
import { h, setPressed, svg } from '../dom.js';
import { percent, plural } from '../format.js';
import { css, qualityColor } from '../palette.js';
import { gainShare } from '../views.js';
import { chartPoint, gainText } from './explore.js';

const CHART = { width: 240, height: 84 };
const CURVES = [['observed', 'seen'], ['completed', 'completed']];

/** Calls `write` with the number of the last view, when that changes. */
function onStep({ stepAt }, { store }, write) {
  let shown = -1;
  store.subscribe(({ time }) => {
    const step = stepAt(time);
    if (step === shown) return;
    shown = step;
    write(step);
  });
}

function createTaken(exploration, player) {
  const { views } = exploration;
  const canvas = h('canvas', { class: 'depth', role: 'img' });
  const [title, gain, share] = [h('strong'), h('span'), h('span')];
  onStep(exploration, player, (step) => {
    const { view, depth, objects, observed, completed } = views[step];
    drawDepth(canvas, depth);
    canvas.setAttribute('aria-label', `Depth image of view ${step + 1}: near is bright`);
    title.textContent = `View ${step + 1} of ${views.length}, candidate ${view.candidate}`;
    const wasRanked = step > 0 && views[step - 1].next.list.length > 0;
    gain.textContent = wasRanked ? `expected gain ${gainText(view.gain, views[step - 1].next.unit)}` : 'chosen without a ranking';
    share.textContent = `${plural(objects, 'object')}, ${percent(observed)} seen, ${percent(completed)} completed`;
  });
  return h('section', { class: 'taken', 'aria-label': 'The last view' }, canvas, h('div', { class: 'facts' }, title, gain, share));
}

function createCurve(key, { views }) {
  const points = views.map((view, step) => chartPoint(step, view[key], views.length, CHART).map((value) => value.toFixed(1)).join());
  return svg('polyline', { class: `curve is-${key}`, points: points.join(' ') });
}

function createDots(key, { views }, { actions }) {
  return views.map((view, step) => {
    const [cx, cy] = chartPoint(step, view[key], views.length, CHART);
    const dot = svg('circle', { class: `dot is-${key}`, cx, cy, r: 3.5 }, svg('title', {}, `View ${step + 1}: ${percent(view[key])}`));
    dot.addEventListener('click', () => actions.goToEvent(step));
    return dot;
  });
}

function createChart(exploration, player) {
  const { views } = exploration;
  const now = svg('line', { class: 'now-line', y1: 0, y2: CHART.height });
  onStep(exploration, player, (step) => {
    const [x] = chartPoint(step, 0, views.length, CHART);
    for (const end of ['x1', 'x2']) now.setAttribute(end, x);
  });
  const grid = [0, 0.5, 1].map((share) => {
    const [, y] = chartPoint(0, share, 2, CHART);
    return svg('g', {}, svg('line', { class: 'grid-line', x1: 0, x2: CHART.width, y1: y, y2: y }), svg('text', { x: -6, y: y + 3 }, percent(share)));
  });
  const last = views[views.length - 1];
  const label = `After ${plural(views.length, 'view')}: ${CURVES.map(([key, text]) => `${percent(last[key])} ${text}`).join(', ')}`;
  return h('section', { class: 'coverage', 'aria-label': 'Known surface' },
    h('div', { class: 'section-head' }, h('h2', {}, 'Known surface'),
      h('span', { class: 'key' }, CURVES.map(([key, text]) => h('span', { class: `is-${key}` }, text)))),
    svg('svg', { viewBox: `-36 -8 ${CHART.width + 46} ${CHART.height + 16}`, class: 'chart', role: 'img', 'aria-label': label },
      ...grid, now, ...CURVES.flatMap(([key]) => [createCurve(key, exploration), ...createDots(key, exploration, player)])),
    h('p', { class: 'more' }, `Share of the true surfaces by view. It ended because ${exploration.end}.`));
}

function createCandidate(next, rank, follows, actions) {
  const { candidate, gain } = next.list[rank];
  return h('li', {}, h('button', {
    type: 'button', class: 'grasp candidate', 'data-candidate': candidate, onclick: () => actions.toggleCandidate(candidate),
  }, h('span', { class: 'quality', style: { '--color': css(qualityColor(gainShare(next, rank))) } }),
  h('span', { class: 'source' }, `View ${candidate}`, follows && h('small', {}, 'taken next')),
  h('span', { class: 'number' }, gainText(gain, next.unit))));
}

function createCandidates(exploration, player) {
  const { views } = exploration;
  const list = h('ul', { class: 'grasps' });
  const aside = h('span', { class: 'aside' });
  const none = h('p', { class: 'more' }, 'The policy ranks no views.');
  const press = ({ candidate }) => {
    for (const button of list.querySelectorAll('button')) setPressed(button, Number(button.dataset.candidate) === candidate);
  };
  onStep(exploration, player, (step) => {
    const { next } = views[step];
    const follower = views[step + 1]?.view.candidate;
    list.replaceChildren(...next.list.map(({ candidate }, rank) => createCandidate(next, rank, candidate === follower, player.actions)));
    aside.textContent = next.list.length > 0 ? `by ${next.policy}` : '';
    none.hidden = next.list.length > 0;
    press(player.store.get());
  });
  player.store.subscribe(press);
  return h('section', { class: 'candidates', 'aria-label': 'Views that could follow' },
    h('div', { class: 'section-head' }, h('h2', {}, 'Views that could follow'), aside), list, none);
}

function createLeftUnknown({ left }) {
  return h('section', { class: 'left', 'aria-label': 'Left unknown' },
    h('div', { class: 'section-head' }, h('h2', {}, 'Left unknown')), h('ul', {}, left.map((sentence) => h('li', {}, sentence))));
}

export function createExplorationSections(recording, player) {
  const { exploration } = recording;
  return [createTaken(exploration, player), createChart(exploration, player), createCandidates(exploration, player), createLeftUnknown(recording)];
}
