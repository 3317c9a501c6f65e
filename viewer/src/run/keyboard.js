// Keys of the player.
import { VIEW_KEYS } from '../camera.js';
import { viewsOf } from './state.js';

const SECOND = 1; // that Shift and an arrow move by [s]

const KEY_HELP = [
  ['Space', 'play, pause'], ['←  →', 'previous, next event'], ['Shift ←  →', 'one second'], ['Home  End', 'begin, end'], ['[  ]', 'slower, faster'],
  ['B', 'both, true, believed'], ['L', 'names'], ['R', 'record a video'], ['H F S T', 'home, front, side, top'], ['+  −', 'zoom'],
];

export const keyHelp = (recording) => KEY_HELP.filter(([key]) => key !== 'B' || viewsOf(recording).length > 1);

function actionsOf({ store, actions, viewpoint, recorder, isNarrow }, recording) {
  const move = (step) => () => actions.seek(store.get().time + step);
  const switchViews = () => {
    const choices = viewsOf(recording).filter((views) => views !== 'both' || !isNarrow());
    actions.setViews(choices[(choices.indexOf(store.get().views) + 1) % choices.length]);
  };
  return {
    ' ': actions.toggle, k: actions.toggle,
    ArrowLeft: actions.previousEvent, ArrowRight: actions.nextEvent,
    'Shift ArrowLeft': move(-SECOND), 'Shift ArrowRight': move(SECOND),
    Home: () => actions.seek(recording.begin), End: () => actions.seek(recording.end),
    '[': () => actions.changeSpeed(-1), ']': () => actions.changeSpeed(1),
    b: switchViews, l: actions.toggleLabels, r: recorder.toggle,
    '+': () => viewpoint.zoom(1 / 1.2), '=': () => viewpoint.zoom(1 / 1.2), '-': () => viewpoint.zoom(1.2),
    ...Object.fromEntries(Object.entries(VIEW_KEYS).map(([key, view]) => [key, () => viewpoint.go(view)])),
  };
}

/** Whether an element with focus uses the key itself. */
function isTaken(target, key) {
  if (key === ' ') return target.matches?.('button, select, summary');
  return target.matches?.('select');
}

export function listenToKeys(app, recording) {
  const keys = actionsOf(app, recording);
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = keys[event.shiftKey && key.startsWith('Arrow') ? `Shift ${key}` : key];
    if (!action || isTaken(event.target, key)) return;
    event.preventDefault();
    if (!(event.repeat && ' kr'.includes(key))) action();
  });
  // A mouse leaves no focus behind, so that space plays after a click.
  document.addEventListener('click', (event) => { if (event.detail > 0) event.target.closest?.('button')?.blur(); });
}
