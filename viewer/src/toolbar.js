// The controls above the scene: colours, layers and views.
import { h, setPressed } from './dom.js';
import { icon } from './icons.js';

const MODES = [
  ['scan', 'Scan', 'Colours of the scan'],
  ['blend', 'Blend', 'Colours of the scan, tinted by object'],
  ['objects', 'Objects', 'One colour per object'],
  ['truth', 'Truth', 'The ground truth: one colour per true object, that of the found object that overlaps it most'],
];
const TOGGLES = [
  ['mesh', 'Mesh', 'Reconstructed surface instead of points (M)'],
  ['planes', 'Planes', 'Mirror planes (P)'],
  ['axes', 'Axes', 'Rotation axes (A)'],
  ['completed', 'Completed', 'Closed surfaces; the inferred side is lighter (C)'],
  ['labels', 'Labels', 'Numbers of objects (L)'],
  ['rest', 'Other', 'Points of no object (O)'],
  ['path', 'Camera', 'Path of the camera (V)'],
  ['grasps', 'Grasps', 'Grippers at the grasps (G)'],
  ['views', 'Views', 'Views that the camera could take next (N)'],
  ['measure', 'Measure', 'Distance between two clicked points (D)'],
];
const VIEWS = [['home', 'Home'], ['front', 'Front'], ['side', 'Side'], ['top', 'Top']];

export function createToolbar(scene, store, actions) {
  const modes = MODES.filter(([mode]) => mode !== 'truth' || scene.truth).map(([mode, text, title]) =>
    h('button', { type: 'button', title, 'data-mode': mode, onclick: () => actions.setMode(mode) }, text));
  const special = { completed: actions.toggleAllCompleted, measure: actions.toggleMeasure };
  const press = (key) => (special[key] ?? (() => actions.toggle(key)))();
  const missing = { mesh: !scene.surface, path: !scene.trajectory, grasps: !scene.grasps, views: !scene.views };
  const toggles = TOGGLES.filter(([key]) => !missing[key]).map(([key, text, title]) =>
    h('button', { type: 'button', title, 'aria-label': text, 'data-toggle': key, onclick: () => press(key) },
      icon(key), h('span', { class: 'text' }, text)));
  const hasCompleted = scene.objects.some((object) => object.hasCompletion);
  toggles.find((button) => button.dataset.toggle === 'completed').disabled = !hasCompleted;
  store.subscribe((state) => {
    for (const button of modes) setPressed(button, state.mode === button.dataset.mode);
    for (const button of toggles) {
      const value = state[button.dataset.toggle];
      setPressed(button, value instanceof Set ? value.size > 0 : value);
    }
  });
  return h('div', { class: 'toolbar', role: 'toolbar', 'aria-label': 'Layers and colours' },
    h('div', { class: 'group modes', role: 'group', 'aria-label': 'Colours' }, modes),
    h('div', { class: 'group toggles', role: 'group', 'aria-label': 'Layers' }, toggles));
}

export function createViews(viewpoint) {
  return h('div', { class: 'views group', role: 'toolbar', 'aria-label': 'Views' },
    VIEWS.map(([view, text]) =>
      h('button', { type: 'button', title: `${text} view (${text[0]})`, 'data-view': view, onclick: () => viewpoint.go(view) },
        view === 'home' ? icon('home') : '', text)));
}
