// The controls of the player, below the views.
import { h, setPressed } from '../dom.js';
import { icon } from '../icons.js';
import { SPEEDS } from './state.js';
import { createTimeline } from './timeline.js';
import { OUTCOMES, clock, outcomeMark } from './words.js';

const iconButton = (name, label, title, onclick) =>
  h('button', { type: 'button', class: `icon-button ${name}`, 'aria-label': label, title, onclick }, icon(name));

function createPlayButton({ store, actions }) {
  const button = iconButton('play', 'Play', 'Play or pause (space)', actions.toggle);
  store.subscribe(({ playing }, changed) => {
    if (!changed.has('playing')) return;
    button.replaceChildren(icon(playing ? 'pause' : 'play'));
    button.setAttribute('aria-label', playing ? 'Pause' : 'Play');
  });
  return button;
}

function createSpeed({ store, actions }) {
  const select = h('select', {
    class: 'speed', 'aria-label': 'Speed', title: 'Speed ([ and ])', onchange: () => { actions.setSpeed(Number(select.value)); select.blur(); },
  }, SPEEDS.map((speed) => h('option', { value: speed }, `${speed}×`)));
  store.subscribe(({ speed }) => { select.value = speed; });
  return select;
}

// Read aloud when it changes, and not while it plays fast.
function createNow(recording, { store, currentEvent }) {
  const now = h('p', { class: 'now', role: 'status' });
  let shown = null;
  store.subscribe(({ time }) => {
    const index = currentEvent(time);
    if (index === shown) return;
    shown = index;
    const event = recording.events[index];
    now.replaceChildren(...(event ? [outcomeMark(event.outcome), h('span', {}, event.text)] : []));
    now.title = event ? `${OUTCOMES[event.outcome]}: ${event.text}` : '';
  });
  return now;
}

function createRecordButton(recorder) {
  const text = h('span', { class: 'text' }, 'Record');
  const button = h('button', {
    type: 'button', class: 'record', disabled: !recorder.supported, onclick: recorder.toggle,
    title: recorder.supported ? 'Saves a video of the views from this moment on (R)' : 'This browser cannot record a canvas',
  }, icon('record'), text);
  recorder.onChange = (recording) => {
    setPressed(button, recording);
    text.textContent = recording ? 'Stop' : 'Record';
    button.firstChild.replaceWith(icon(recording ? 'stop' : 'record'));
  };
  return button;
}

export function createPlayer(recording, player, recorder) {
  const { store, actions } = player;
  const time = h('span', { class: 'time' });
  store.subscribe((state) => { time.textContent = `${clock(state.time)} / ${clock(recording.end)}`; });
  return h('section', { class: 'player', 'aria-label': 'Player' }, createTimeline(recording, player),
    h('div', { class: 'row' },
      iconButton('previous', 'Previous event', 'Previous event (←)', actions.previousEvent),
      createPlayButton(player),
      iconButton('next', 'Next event', 'Next event (→)', actions.nextEvent),
      time, createNow(recording, player), createSpeed(player), createRecordButton(recorder)));
}
