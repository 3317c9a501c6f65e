// The sweep of the camera, played with its depth images.
import { drawDepth } from '../depth_image.js';
import { h } from '../dom.js';
import { icon } from '../icons.js';

const STEP = 120; // ms per frame

// Advances the moment while the sweep plays; the end stops it.
function keepPlaying(count, store) {
  let timer = 0;
  const step = () => {
    const { moment } = store.get();
    if (moment + 1 < count) store.set({ moment: moment + 1 });
    else store.set({ playing: false });
  };
  store.subscribe(({ playing }, changed) => {
    if (!changed.has('playing')) return;
    clearInterval(timer);
    if (!playing) return;
    if (store.get().moment + 1 >= count) store.set({ moment: 0 });
    timer = setInterval(step, STEP);
  });
}

export function createSweepSection({ sweep }, store, actions) {
  if (!sweep) return null;
  const canvas = h('canvas', { class: 'depth', role: 'img', 'aria-label': 'Depth image of the frame: near is bright' });
  const play = h('button', { class: 'icon-button', type: 'button', 'aria-label': 'Play the sweep', onclick: () => {
    if (!store.get().path) store.set({ path: true });
    actions.togglePlaying();
  } });
  const slider = h('input', {
    type: 'range', min: '0', max: String(sweep.length - 1), value: '0', 'aria-label': 'Frame of the sweep',
    oninput: () => store.set({ moment: Number(slider.value), playing: false }),
  });
  const number = h('span', { class: 'number' });
  store.subscribe(({ moment, playing }, changed) => {
    if (changed.has('playing')) play.replaceChildren(icon(playing ? 'pause' : 'play'));
    if (!changed.has('moment')) return;
    const shown = moment ?? 0;
    drawDepth(canvas, sweep[shown].depth);
    slider.value = String(shown);
    number.textContent = `${shown + 1} of ${sweep.length}`;
  });
  keepPlaying(sweep.length, store);
  return h('details', { class: 'sweep-section', open: true },
    h('summary', {}, 'Sweep of the camera', h('span', { class: 'aside' }, number)),
    h('div', { class: 'player' }, canvas, h('div', { class: 'transport' }, play, slider)));
}
