// The slider of time with a mark for every event that is more than a note.
import { h } from '../dom.js';
import { OUTCOMES, clock, outcomeMark } from './words.js';

/** Where a time is on the slider, from 0 to 1. */
const share = (time, { begin, end }) => (end > begin ? Math.min(1, Math.max(0, (time - begin) / (end - begin))) : 0);

function createMarks(recording, actions) {
  return recording.events.map((event, index) => ({ event, index })).filter(({ event }) => event.outcome !== 'note')
    .map(({ event, index }) => h('button', {
      class: 'at', type: 'button', tabindex: '-1', 'aria-hidden': 'true', style: { '--at': share(event.time, recording) },
      title: `${clock(event.time)}  ${OUTCOMES[event.outcome]}: ${event.text}`, onclick: () => actions.goToEvent(index),
    }, outcomeMark(event.outcome)));
}

function createLooks(recording) {
  return recording.beliefTimes.map((time, i) =>
    h('span', { class: 'look', style: { '--at': share(time, recording) }, title: `Look ${i + 1}` }));
}

export function createTimeline(recording, { store, actions }) {
  const { begin, end } = recording;
  const slider = h('input', {
    type: 'range', class: 'slider', min: begin, max: end, step: 'any', 'aria-label': 'Time',
    oninput: () => { actions.pause(); actions.seek(Number(slider.value)); },
    // The arrow keys of a slider with focus move it; after a drag they go to events again.
    onpointerup: () => slider.blur(),
    onkeydown: (event) => {
      const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      actions.seek(store.get().time + (step * (end - begin)) / 100);
    },
  });
  store.subscribe(({ time }) => {
    slider.value = time;
    slider.style.setProperty('--at', share(time, recording));
    slider.setAttribute('aria-valuetext', `${clock(time)} of ${clock(end)}`);
  });
  return h('div', { class: 'timeline' }, h('div', { class: 'marks' }, createMarks(recording, actions)),
    h('div', { class: 'looks', 'aria-hidden': 'true' }, createLooks(recording)), slider);
}
