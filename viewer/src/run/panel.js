// The panel beside the views: summary, events, what was left, help.
import { h } from '../dom.js';
import { createExplorationSections } from './explore_panel.js';
import { keyHelp } from './keyboard.js';
import { createPlanSections } from './plan_panel.js';
import { OUTCOMES, clock, outcomeMark, summary } from './words.js';

function createEvent(event, index, actions) {
  const named = event.outcome !== 'note';
  return h('li', {}, h('button', { type: 'button', class: `event is-${event.outcome}`, 'data-event': index, onclick: () => actions.goToEvent(index) },
    h('span', { class: 'when' }, clock(event.time)), outcomeMark(event.outcome),
    h('span', { class: 'what' }, named && h('span', { class: 'hidden-text' }, `${OUTCOMES[event.outcome]}: `), event.text)));
}

function createEvents({ events }, { store, actions, currentEvent }) {
  if (events.length === 0) return h('p', { class: 'more' }, 'There are none.');
  const rows = events.map((event, index) => createEvent(event, index, actions));
  const list = h('ol', { class: 'events' }, rows);
  let shown = null;
  store.subscribe(({ time }) => {
    const index = currentEvent(time);
    if (index === shown) return;
    rows[shown]?.firstChild.removeAttribute('aria-current');
    rows[index]?.firstChild.setAttribute('aria-current', 'true');
    // The panel begins at its top, and does not move under the mouse.
    if (shown !== null && !list.matches(':hover, :focus-within')) (rows[index] ?? rows[0]).scrollIntoView({ block: 'nearest' });
    shown = index;
  });
  return list;
}

function createLeft({ left }) {
  return h('section', { class: 'left', 'aria-label': 'Not picked' },
    h('div', { class: 'section-head' }, h('h2', {}, 'Not picked'), h('span', { class: 'aside' }, String(left.length))),
    left.length > 0 ? h('ul', {}, left.map((reason) => h('li', {}, reason))) : h('p', { class: 'more' }, 'Nothing was left.'));
}

function createHelp(recording) {
  const rows = [['Drag', 'orbit'], ['Right drag, two fingers', 'pan'], ['Wheel, pinch', 'zoom'], ...keyHelp(recording)];
  return h('details', { class: 'controls' }, h('summary', {}, 'Controls'),
    h('dl', {}, rows.flatMap(([key, use]) => [h('dt', {}, key), h('dd', {}, use)])),
    !recording.plan && h('p', { class: 'more' }, 'A believed object has the colour of the true object whose middle is nearest, within half of its size; without one it is grey. ' +
      'Ticks on the slider are looks.'));
}

function createSections(recording, player) {
  if (recording.exploration) return createExplorationSections(recording, player);
  return recording.plan ? createPlanSections(recording.plan, player) : createLeft(recording);
}

const nameOf = ({ plan, exploration }) => (exploration ? 'The exploration' : (plan ? 'The plan' : 'The run'));

export function createPanel(recording, player) {
  return h('aside', { class: 'panel', 'aria-label': nameOf(recording) },
    h('header', {}, h('h1', {}, recording.title || 'Run'), h('p', { class: 'stats' }, summary(recording))),
    h('div', { class: 'scroll', tabindex: '-1' },
      createSections(recording, player),
      h('div', { class: 'section-head' }, h('h2', {}, 'Events'), h('span', { class: 'aside' }, String(recording.events.length))),
      createEvents(recording, player), createHelp(recording)));
}
