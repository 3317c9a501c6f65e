// The ground truth beside the result: every true object with what was found of it.
import { h } from '../dom.js';
import * as format from '../format.js';
import { css, objectColor } from '../palette.js';

function truthRow({ name, points, best, isFound }, scene, actions) {
  const text = best ? `${scene.objects[best.index].name}, IoU ${format.fixed(best.overlap, 2)}` : points > 0 ? 'missed' : 'not seen';
  return h('li', {}, h('button', {
    class: 'grasp', type: 'button', disabled: !best, onclick: () => actions.select(best.index),
  }, h('span', { class: 'quality', style: { '--color': css(isFound ? objectColor(best.index) : [138, 144, 154]) } }),
  h('span', { class: 'source' }, name), h('span', { class: 'number' }, text)));
}

/** The section of a scene whose ground truth is known. */
export function createTruthSection(scene, actions) {
  if (!scene.truth) return null;
  const found = scene.compared.filter(({ isFound }) => isFound).length;
  return h('details', { class: 'truth-section', open: true },
    h('summary', {}, 'Ground truth', h('span', { class: 'aside' }, `${found} of ${format.plural(scene.truth.length, 'object')} found`)),
    h('p', { class: 'more' }, 'Found: the intersection over union of points (IoU) with an object is at least 0.5. The mode Truth colours the true objects.'),
    h('ul', { class: 'grasps' }, scene.compared.map((entry) => truthRow(entry, scene, actions))));
}
