// Connects the recording, the state of the player, the views and the controls.
import { h } from '../dom.js';
import { applyHash, keepTimeInHash, timeIn } from './hash.js';
import { createHook } from './hook.js';
import { listenToKeys } from './keyboard.js';
import { createCaptions, createViewControls } from './overlay.js';
import { createPanel } from './panel.js';
import { createPlayer } from './player.js';
import { Recorder } from './recorder.js';
import { createPlayerState } from './state.js';
import { RunView } from './view.js';

const NARROW = '(max-width: 799px)'; // as in run.css
const LONGEST_STEP = 0.5; // of the watch; a page in the background does not run on [s]

function playOnFrames({ store, actions }) {
  let last = 0;
  const step = (now) => {
    if (!store.get().playing) return;
    actions.advance(Math.min(LONGEST_STEP, (now - last) / 1000));
    last = now;
    requestAnimationFrame(step);
  };
  store.subscribe(({ playing }, changed) => {
    if (!changed.has('playing') || !playing) return;
    last = performance.now();
    requestAnimationFrame(step);
  });
}

function drawOnChange(view, store) {
  store.subscribe((_, changed) => {
    if (changed.has('views')) view.reframe();
    view.element.dataset.views = store.get().views;
    view.invalidate();
  });
  const scheme = matchMedia('(prefers-color-scheme: dark)');
  const applyScheme = () => view.setScheme(scheme.matches ? 'dark' : 'light');
  scheme.addEventListener('change', applyScheme);
  applyScheme();
}

// One view on a narrow screen; both again when it gets wide.
function followWidth({ store, actions }) {
  const narrow = matchMedia(NARROW);
  const apply = () => {
    if (narrow.matches && store.get().views === 'both') actions.setViews('true');
    if (!narrow.matches) actions.setViews('both');
  };
  narrow.addEventListener('change', apply);
  store.subscribe(() => { if (narrow.matches && store.get().views === 'both') actions.setViews('true'); });
  return () => narrow.matches;
}

export function createApp(recording) {
  const player = createPlayerState(recording);
  player.actions.seek(timeIn(location.hash)); // before the panel, which follows later changes
  const view = new RunView(recording, player.store);
  const recorder = new Recorder(view, player, recording);
  const isNarrow = followWidth(player);
  const stage = h('main', { class: 'views-area' }, view.element, createCaptions(recording, player.store));
  document.body.append(stage, createPlayer(recording, player, recorder), createPanel(recording, player));
  view.attach();
  stage.append(...createViewControls(view.viewpoint, recording, player));
  const app = { ...player, view, viewpoint: view.viewpoint, recorder, isNarrow };
  drawOnChange(view, player.store);
  playOnFrames(player);
  listenToKeys(app, recording);
  const readHash = () => applyHash(location.hash, app);
  addEventListener('hashchange', readHash);
  readHash();
  keepTimeInHash(player.store);
  createHook(recording, app);
}
