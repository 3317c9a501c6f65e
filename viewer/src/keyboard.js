// Keys: arrows orbit while the canvas has focus; letters work everywhere.
import { VIEW_KEYS } from './camera.js';

const TOGGLE_KEYS = { p: 'planes', a: 'axes', l: 'labels', o: 'rest', m: 'mesh', v: 'path', g: 'grasps', n: 'views' };
const MODE_KEYS = { 1: 'scan', 2: 'blend', 3: 'objects' };
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const STEP = 8; // degrees

export const KEY_HELP = [
  ['Arrows', 'orbit (with Shift: pan)'], ['+  −', 'zoom'], ['H F S T', 'home, front, side, top'],
  ['[  ]', 'previous, next object'], ['P A C', 'planes, axes, completed objects'],
  ['M V G N', 'mesh, camera path, grasps, next views'], ['L O', 'labels, other points'], ['1 2 3 4', 'scan, blend, objects, ground truth'],
  ['D', 'measure distances'], ['Esc', 'clear selection and marks'],
];

function moveCamera(event, viewpoint) {
  const arrow = ARROWS[event.key];
  if (arrow && event.shiftKey) viewpoint.pan(...arrow);
  else if (arrow) viewpoint.orbit(STEP * arrow[0], STEP * arrow[1]);
  else if (event.key === '+' || event.key === '=') viewpoint.zoom(1 / 1.2);
  else if (event.key === '-') viewpoint.zoom(1.2);
  else return false;
  return true;
}

function stepSelection(store, actions, objects, step) {
  if (objects.length === 0) return;
  const { selected } = store.get();
  const start = selected === null ? (step > 0 ? -1 : 0) : selected;
  actions.select((start + step + objects.length) % objects.length);
}

function press(key, { scene, store, actions, objects, viewpoint }) {
  if (VIEW_KEYS[key]) viewpoint.go(VIEW_KEYS[key]);
  else if (TOGGLE_KEYS[key]) actions.toggle(TOGGLE_KEYS[key]);
  else if (key === 'c') actions.toggleAllCompleted();
  else if (MODE_KEYS[key]) actions.setMode(MODE_KEYS[key]);
  else if (key === '4' && scene.truth) actions.setMode('truth');
  else if (key === 'd') actions.toggleMeasure();
  else if (key === ']') stepSelection(store, actions, objects, 1);
  else if (key === '[') stepSelection(store, actions, objects, -1);
  else if (key === 'escape') store.set({ selected: null, rejection: null, marks: [] });
  else return false;
  return true;
}

export function listenToKeys(app) {
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const onCanvas = event.target === app.canvas || event.target === document.body;
    if ((onCanvas && moveCamera(event, app.viewpoint)) || press(event.key.toLowerCase(), app)) {
      event.preventDefault();
    }
  });
}
