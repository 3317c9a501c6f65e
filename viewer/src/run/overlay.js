// What lies over the views: their captions, and the choice of views.
import { h, setPressed } from '../dom.js';
import { icon } from '../icons.js';
import { createViews } from '../toolbar.js';
import { knownText } from './explore.js';
import { viewsOf } from './state.js';
import { clock, progress } from './words.js';

const choicesOf = ({ exploration }) => [['both', 'Both'], ['true', 'True'], ['believed', exploration ? 'Known' : 'Believed']];

export function beliefText({ beliefTimes, beliefAt, believed, exploration }, time) {
  if (exploration) return knownText(exploration, time);
  const index = beliefAt(time);
  if (index < 0) return 'before the first look';
  const count = believed(index).length;
  return `look ${index + 1} of ${beliefTimes.length}, at ${clock(beliefTimes[index])}: ${count === 1 ? '1 object' : `${count} objects`}`;
}

export function createCaptions(recording, store) {
  const details = { true: h('small'), believed: h('small') };
  const captions = {
    true: h('h2', { class: 'caption' }, recording.plan ? 'Planned motion' : 'True scene', details.true),
    believed: h('h2', { class: 'caption' }, recording.exploration ? 'What is known' : 'What the robot believes', details.believed),
  };
  const write = (side, text) => { if (details[side].textContent !== text) details[side].textContent = text; };
  store.subscribe(({ time, views }) => {
    for (const [side, caption] of Object.entries(captions)) caption.hidden = views !== 'both' && views !== side;
    write('true', progress(recording, time));
    write('believed', beliefText(recording, time));
  });
  return h('div', { class: 'captions' }, captions.true, captions.believed);
}

function createChoice(recording, { store, actions }) {
  const buttons = choicesOf(recording).map(([views, text]) => h('button', {
    type: 'button', 'data-views': views, title: `${text === 'Both' ? 'Both views' : `${text} scene`} (B)`, onclick: () => actions.setViews(views),
  }, text));
  const labels = h('button', { type: 'button', class: 'labels-toggle', 'aria-label': 'Names', title: 'Names of objects (L)', onclick: actions.toggleLabels }, icon('labels'));
  store.subscribe((state) => {
    for (const button of buttons) setPressed(button, state.views === button.dataset.views);
    setPressed(labels, state.labels);
  });
  return [
    viewsOf(recording).length > 1 && h('div', { class: 'group modes choice', role: 'group', 'aria-label': 'Shown scene' }, buttons),
    h('div', { class: 'group labels-group' }, labels),
  ].filter(Boolean);
}

export function createViewControls(viewpoint, recording, player) {
  return [createViews(viewpoint), ...createChoice(recording, player)];
}
