// The panel beside the scene; on a narrow screen a sheet below it.
import { h } from '../dom.js';
import * as format from '../format.js';
import { KEY_HELP } from '../keyboard.js';
import { createExportButtons } from './exports.js';
import { createGraspSection } from './grasps.js';
import { createObjectList } from './objects.js';
import { createSweepSection } from './sweep.js';
import { createTruthSection } from './truth.js';
import { createViewSection } from './views.js';
import { createTimes, totalTime } from './times.js';
import { createWhy } from './why.js';

const HEIGHTS = ['peek', 'half', 'full'];

function stats({ objects, cloud, timings, noun }) {
  const parts = [format.plural(objects.length, noun), format.plural(cloud.count, 'point')];
  if (timings.length) parts.push(format.seconds(totalTime(timings)));
  return parts.join(' · ');
}

function pathLength(path) {
  let sum = 0;
  for (let i = 3; i < path.length; i += 3) {
    sum += Math.hypot(path[i] - path[i - 3], path[i + 1] - path[i - 2], path[i + 2] - path[i - 1]);
  }
  return sum;
}

function cameraText({ frames, path }) {
  if (frames === 1) return 'Camera: 1 frame.';
  return `Camera: ${format.plural(frames, 'frame')} over ${format.fixed(pathLength(path), 2)} m, its first pyramid filled.`;
}

// Explains the layers of the reconstruction.
function createLegend({ surface, trajectory }) {
  const parts = [];
  if (surface) {
    parts.push(`Mesh: the reconstructed surface, objects in their colours (${format.plural(surface.triangles.length / 3, 'triangle')}).`);
  }
  if (trajectory) parts.push(cameraText(trajectory));
  return parts.length > 0 && h('p', { class: 'lead' }, parts.join(' '));
}

function createControlsHelp(cell) {
  const rows = [
    ['Drag', 'orbit'], ['Right drag, two fingers', 'pan'], ['Wheel, pinch', 'zoom'], ['Click', 'select'], ...KEY_HELP,
  ];
  const size = cell >= 1 ? `${cell} m` : `${Math.round(cell * 1000) / 10} cm`;
  return h('details', { class: 'controls' }, h('summary', {}, 'Controls'),
    h('dl', {}, rows.flatMap(([key, use]) => [h('dt', {}, key), h('dd', {}, use)])),
    h('p', { class: 'more' }, `Grid of the table: ${size} per square, bold lines every five.`));
}

function createWarnings({ warnings }) {
  return warnings.length > 0 && h('section', { class: 'warnings', role: 'status', 'aria-label': 'Warnings' },
    h('h2', {}, 'Warnings'), h('ul', {}, warnings.map((warning) => h('li', {}, warning))));
}

function emptyMessage(scene) {
  const rejected = scene.rejected.length;
  return h('div', { class: 'empty', role: 'status' },
    h('strong', {}, 'No object was found.'),
    scene.cloud.count === 0 && scene.surface ? 'Nothing stands on the table: the mesh shows all that was seen.'
      : scene.cloud.count === 0 ? 'The cloud has no points.'
      : rejected ? `${format.plural(rejected, 'hypothesis').replace('hypothesiss', 'hypotheses')} rejected; “Why these objects” lists the reasons.`
        : 'No candidate passed all steps; “Why these objects” shows how many passed each.');
}

// Dragging the grip sets the sheet's height; a tap cycles through three heights.
function createGrip(panel, onResize) {
  const set = (name) => { panel.dataset.height = name; panel.style.removeProperty('--sheet'); onResize(); };
  let drag = null;
  const grip = h('button', { class: 'grip', type: 'button', 'aria-label': 'Height of the panel' }, h('span'));
  grip.addEventListener('pointerdown', (event) => {
    drag = { y: event.clientY, height: panel.offsetHeight, moved: false };
    grip.setPointerCapture(event.pointerId);
  });
  grip.addEventListener('pointermove', (event) => {
    if (!drag || (!drag.moved && Math.abs(event.clientY - drag.y) < 4)) return;
    drag.moved = true;
    const height = Math.min(Math.max(drag.height + drag.y - event.clientY, 84), innerHeight * 0.85);
    panel.style.setProperty('--sheet', `${height}px`);
    onResize();
  });
  grip.addEventListener('pointerup', () => { if (drag?.moved) grip.dataset.moved = ''; drag = null; });
  grip.addEventListener('click', () => {
    if ('moved' in grip.dataset) delete grip.dataset.moved;
    else set(HEIGHTS[(HEIGHTS.indexOf(panel.dataset.height) + 1) % HEIGHTS.length]);
  });
  return grip;
}

export function createPanel({ scene, store, actions, extentOf, cell, onResize, exports }) {
  const hasObjects = scene.objects.length > 0;
  const panel = h('aside', { class: 'panel', 'data-height': 'half', 'aria-label': 'Segmentation result' });
  panel.append(
    createGrip(panel, onResize),
    h('header', {},
      h('h1', {}, scene.title || 'Segmentation'),
      h('p', { class: 'stats' }, stats(scene))),
    h('div', { class: 'scroll', tabindex: '-1' },
      createExportButtons(scene, exports),
      scene.note && h('p', { class: 'note' }, scene.note),
      createWarnings(scene),
      hasObjects && h('p', { class: 'lead' }, `One colour per ${scene.noun}. Sheets are mirror planes, ` +
        'arrows are axes of rotation. Click one for details.'),
      createLegend(scene),
      hasObjects ? createObjectList(scene, store, actions, extentOf, exports) : emptyMessage(scene),
      createSweepSection(scene, store, actions),
      createTruthSection(scene, actions),
      createGraspSection(scene),
      createViewSection(scene, store, actions),
      createTimes(scene.timings), createWhy(scene, store, actions, !hasObjects), createControlsHelp(cell)));
  return panel;
}
