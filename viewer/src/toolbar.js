// The controls over the scene: colours, what is drawn, and where it is seen from.
import { h, setPressed } from './dom.js';
import { icon } from './icons.js';

const MODES = [
  ['scan', 'Scan', 'The colours that the camera saw'],
  ['blend', 'Blend', 'Both: the scan, tinted by object'],
  ['objects', 'Objects', 'A colour for every object'],
];
const TOGGLES = [
  ['mesh', 'Mesh', 'The reconstructed surface; without it, the points (M)'],
  ['planes', 'Planes', 'Mirror planes (P)'],
  ['axes', 'Axes', 'Rotation axes (A)'],
  ['completed', 'Completed', 'Points that the symmetries add behind the visible surface (C)'],
  ['labels', 'Labels', 'Numbers (L)'],
  ['rest', 'Other', 'Points that belong to no object (O)'],
  ['path', 'Camera', 'The path of the camera (V)'],
];
const VIEWS = [['home', 'Home'], ['front', 'Front'], ['side', 'Side'], ['top', 'Top']];

export function createToolbar(scene, store, actions) {
  const modes = MODES.map(([mode, text, title]) =>
    h('button', { type: 'button', title, 'data-mode': mode, onclick: () => actions.setMode(mode) }, text));
  const press = (key) => (key === 'completed' ? actions.toggleAllCompleted() : actions.toggle(key));
  const missing = { mesh: !scene.surface, path: !scene.trajectory };
  const toggles = TOGGLES.filter(([key]) => !missing[key]).map(([key, text, title]) =>
    h('button', { type: 'button', title, 'aria-label': text, 'data-toggle': key, onclick: () => press(key) },
      icon(key), h('span', { class: 'text' }, text)));
  const hasCompleted = scene.objects.some((object) => object.completed.count > 0);
  toggles.find((button) => button.dataset.toggle === 'completed').disabled = !hasCompleted;
  store.subscribe((state) => {
    for (const button of modes) setPressed(button, state.mode === button.dataset.mode);
    for (const button of toggles) {
      const value = state[button.dataset.toggle];
      setPressed(button, value instanceof Set ? value.size > 0 : value);
    }
  });
  return h('div', { class: 'toolbar', role: 'toolbar', 'aria-label': 'What is drawn' },
    h('div', { class: 'group modes', role: 'group', 'aria-label': 'Colours' }, modes),
    h('div', { class: 'group toggles', role: 'group', 'aria-label': 'Layers' }, toggles));
}

export function createViews(viewpoint) {
  return h('div', { class: 'views group', role: 'toolbar', 'aria-label': 'Views' },
    VIEWS.map(([view, text]) =>
      h('button', { type: 'button', title: `${text} view (${text[0]})`, 'data-view': view, onclick: () => viewpoint.go(view) },
        view === 'home' ? icon('home') : '', text)));
}
