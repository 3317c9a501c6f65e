// What is found, what changed, and the state of the connection.
import { h } from '../dom.js';
import { css, inkOn, objectColor } from '../palette.js';

const STATES = { waiting: 'connecting', live: 'live', lost: 'connection lost, trying again', refused: 'the server refuses this page', finished: 'the last frame is in' };
const CHANGES = { appeared: 'appeared', returned: 'returned', unclear: 'is unclear: its points match no object', gone: 'is gone' };
const LOGGED = 60;

const seconds = (value) => (value < 10 ? `${value.toFixed(2)} s` : `${value.toFixed(1)} s`);
const counted = (count, noun) => `${count} ${noun}${count === 1 ? '' : 's'}`;

function chip(number) {
  const color = objectColor(number - 1);
  return h('span', { class: 'chip', style: { background: css(color), color: inkOn(color) } }, String(number));
}

function objectRow({ number, points, score, class: kind }) {
  const known = kind && kind !== 'none' ? kind.replace('_', '-') : 'no symmetry known';
  return h('li', { 'data-number': number }, chip(number), h('span', { class: 'kind' }, known),
    h('span', { class: 'count' }, `${points} points`), h('span', { class: 'score', title: 'probability of being one whole object' }, score.toFixed(2)));
}

export class LivePanel {
  constructor(title) {
    this.state = h('span', { class: 'state', role: 'status' }, STATES.waiting);
    this.facts = h('p', { class: 'facts' });
    this.latency = h('p', { class: 'latency' });
    this.problem = h('p', { class: 'problem', hidden: true });
    this.error = h('p', { class: 'problem', role: 'alert', hidden: true });
    this.objects = h('ul', { class: 'objects' });
    this.log = h('ul', { class: 'log' });
    this.element = h('aside', { class: 'panel', 'aria-label': 'Objects' },
      h('h1', {}, title), this.state, this.facts, this.latency, this.problem, this.error,
      h('h2', {}, 'Objects'), this.objects, h('h2', {}, 'Changes'), this.log);
  }

  setState(state) {
    this.state.textContent = STATES[state];
    this.state.dataset.state = state;
  }

  /** Why the last request for an update failed; null if it did not. */
  setError(error) {
    this.error.textContent = error ? `The update cannot be read (${error}); trying again.` : '';
    this.error.hidden = !error;
  }

  /** Of an update that is shown; `received` is how long the page waited for its points, or null if the update is an old one. [s] */
  show({ report, numbers, size }, received) {
    this.facts.textContent = `update ${report.update} · ${counted(report.frames, 'frame')}${report.lost ? `, ${report.lost} lost` : ''} · ` +
      (numbers.length < size ? `${numbers.length} of ${size} points` : `${size} points`);
    this.latency.textContent = received === null ? `objects were found ${seconds(report.latency)} after the last frame`
      : `${seconds(report.latency + received)} behind the camera (objects ${seconds(report.latency)}, page ${seconds(received)})`;
    this.problem.textContent = report.problem ? `No scene yet: ${report.problem}` : '';
    this.problem.hidden = !report.problem;
    this.objects.replaceChildren(...report.objects.slice().sort((a, b) => a.number - b.number).map(objectRow));
  }

  /** Of each update that arrives. */
  addChanges({ changes, frames }) {
    for (const { number, kind } of changes) {
      this.log.prepend(h('li', {}, chip(number), h('span', {}, `${CHANGES[kind] ?? kind} after ${counted(frames, 'frame')}`)));
    }
    while (this.log.children.length > LOGGED) this.log.lastChild.remove();
  }
}
