// Keeps the hash of the address up to date, so that the address shows what the page shows. Controls that are as the page
// begins are left out.
import { createHashWriter } from './hash_writer.js';
import { initialState } from './store.js';

const SWITCHES = ['planes', 'axes', 'labels', 'rest', 'mesh', 'path', 'grasps', 'views'];
const DELAY = 250; // ms; while the view moves the address waits

const ids = (set, objects) => objects.filter(({ index }) => set.has(index)).map(({ id }) => id).join(',');

function objectParts({ visible, completed, selected }, objects) {
  const parts = [];
  if (selected !== null) parts.push(['select', objects[selected].id]);
  if (visible.size < objects.length) parts.push(['only', ids(visible, objects)]);
  if (completed.size > 0) parts.push(['completed', completed.size === objects.length ? 'all' : ids(completed, objects)]);
  return parts;
}

function cameraPart(viewpoint, frame) {
  if (viewpoint.view === 'home') return [];
  if (viewpoint.view) return [['view', viewpoint.view]];
  const { camera, controls } = viewpoint;
  const numbers = [camera.position, controls.target].flatMap((p) => frame.toWorld(p.toArray()));
  return [['camera', numbers.map((value) => Number(value.toFixed(4))).join(',')]];
}

/** The hash of a state, without "#"; empty for the beginning. */
export function hashOf(state, { scene, objects, viewpoint }) {
  const initial = initialState(scene);
  const parts = cameraPart(viewpoint, scene.frame);
  if (state.mode !== initial.mode) parts.push(['mode', state.mode]);
  for (const key of SWITCHES) if (state[key] !== initial[key]) parts.push([key, state[key] ? 1 : 0]);
  parts.push(...objectParts(state, objects));
  if (state.grasp !== null) parts.push(['grasp', state.grasp]);
  if (state.rejection !== null) parts.push(['rejected', state.rejection]);
  return parts.map(([key, value]) => `${key}=${value}`).join('&');
}

export function keepAddress(app) {
  let timer = 0;
  const replaceHash = createHashWriter();
  const write = () => replaceHash(hashOf(app.store.get(), app));
  const later = () => { clearTimeout(timer); timer = setTimeout(write, DELAY); };
  app.store.subscribe(later);
  app.viewpoint.controls.addEventListener('change', later);
  app.viewpoint.listeners.push(later);
  return { write };
}
