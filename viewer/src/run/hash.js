// The hash of the address sets moment and view: #t=12.3&view=top&show=believed&speed=2&labels=0. The page keeps `t` up to date.
import { isView } from '../camera.js';
import { createHashWriter } from '../hash_writer.js';

const DELAY = 1000; // between changes of the address while it plays [ms]

export function timeIn(hash) {
  const time = new URLSearchParams(hash.replace(/^#/, '')).get('t');
  return time ? Number(time) : NaN;
}

export function applyHash(hash, { store, actions, viewpoint }) {
  const wanted = new URLSearchParams(hash.replace(/^#/, ''));
  if (wanted.has('show')) actions.setViews(wanted.get('show'));
  if (wanted.has('speed')) actions.setSpeed(Number(wanted.get('speed')));
  if (wanted.has('labels')) store.set({ labels: wanted.get('labels') !== '0' });
  if (isView(wanted.get('view'))) viewpoint.go(wanted.get('view'), false);
  actions.seek(timeIn(hash));
}

/** Writes the time into the address, without a new entry in the history. */
export function keepTimeInHash(store) {
  let timer = 0;
  let known = store.get().time;
  const replaceHash = createHashWriter();
  const write = () => {
    timer = 0;
    known = store.get().time;
    const wanted = new URLSearchParams(location.hash.replace(/^#/, ''));
    wanted.set('t', known.toFixed(2));
    replaceHash(String(wanted));
  };
  store.subscribe(({ time, playing }, changed) => {
    if (time === known || !(changed.has('time') || changed.has('playing'))) return;
    if (!playing && timer) { clearTimeout(timer); timer = 0; }
    if (!timer) timer = setTimeout(write, playing ? DELAY : 100);
  });
}
