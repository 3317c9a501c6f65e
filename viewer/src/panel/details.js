// Details of one object.
import { h } from '../dom.js';
import * as format from '../format.js';
import { truthOf } from '../truth.js';
import { createEffects } from './effects.js';
import { copyButton } from './exports.js';

const vector = (v, digits) => v.map((value) => format.fixed(value, digits)).join(', ');

function why(object) {
  const fits = (list) => Math.min(...list.map((s) => s.residual ?? Infinity));
  const parts = [];
  if (object.rotational.length) {
    parts.push(`${object.rotational.length === 1 ? 'rotation about an axis maps' : `rotations about ${object.rotational.length} axes map`} them onto themselves (residual ${format.fixed(fits(object.rotational), 3)})`);
  }
  if (object.reflectional.length) {
    parts.push(`${object.reflectional.length === 1 ? 'a plane mirrors' : `${object.reflectional.length} planes mirror`} one half onto the other (residual ${format.fixed(fits(object.reflectional), 3)})`);
  }
  if (parts.length === 0) return 'This object has no symmetry.';
  return `Symmetries of these points: ${parts.join(', and ')}. Their images lie on the surface or in space that the camera could not see.`;
}

function completion(object) {
  if (!object.hasCompletion) return 'none';
  return object.completed.count > 0 ? `+ ${format.count(object.completed.count)}` : 'closed surface';
}

const CLASSES = {
  mirror: 'one mirror plane', prism: 'two perpendicular planes', box: 'three perpendicular planes',
  revolution: 'solid of revolution', cylinder: 'axis and a plane across it', sphere: 'centre',
};
const SURFACES = { box: 'box', cylinder: 'cylinder', sphere: 'sphere' };

function className({ name, order, dimensions }) {
  if (name === 'n_fold') return `${order}-fold axis`;
  return (dimensions.length ? SURFACES[name] : CLASSES[name]) ?? name;
}

const hundredths = (value) => format.fixed(100 * value, 2);

// The class and its fitted lengths, with their standard deviations.
function classFacts(shape) {
  if (!shape || shape.name === 'none') return [];
  const lengths = shape.dimensions.map(({ name, value, sigma, at_least: least, reason }) => [
    format.words(name),
    sigma === undefined ? `at least ${format.centimetres(least)} cm (${reason})` : `${hundredths(value)} ± ${hundredths(sigma)} cm`,
  ]);
  return [['Class', className(shape)], ...lengths];
}

function truthFacts(object, truth) {
  if (!truth) return [];
  const best = truthOf(truth, object);
  return [['Ground truth', best ? `${best.name}, IoU ${format.fixed(best.overlap, 2)}` : 'no object']];
}

function facts(object, scene, extent) {
  const share = object.points.length / Math.max(1, scene.cloud.count);
  return [
    ['Score', format.fixed(object.score, 3)],
    ...truthFacts(object, scene.truth),
    ['Points seen', `${format.count(object.points.length)} (${format.percent(share)})`],
    ['Completed', completion(object)],
    ...classFacts(object.shape),
    ...(object.volume ? [['Volume', `${format.fixed(1e6 * object.volume, 0)} cm³`]] : []),
    ['Size', `${extent.map(format.centimetres).join(' × ')} cm`],
    ...(object.centroid ? [['Centroid', `${vector(object.centroid, 3)} m`]] : []),
  ];
}

function symmetryRows(object) {
  const row = (kind, s, first, second, names) =>
    h('tr', { title: `${names[0]} ${vector(first, 3)} m, ${names[1]} ${vector(second, 3)}` },
      h('th', { scope: 'row' }, kind), h('td', {}, vector(second, 2)), h('td', {}, format.fixed(s.residual, 3)));
  return [
    ...object.rotational.map((s) => row('Axis', s, s.point, s.direction, ['through', 'along'])),
    ...object.reflectional.map((s) => row('Plane', s, s.point, s.normal, ['through', 'normal'])),
  ];
}

export function objectDetails(object, scene, extent, exports) {
  const rows = symmetryRows(object);
  return h('div', {},
    h('dl', {}, facts(object, scene, extent).flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)])),
    rows.length > 0 && h('table', { class: 'symmetries' },
      h('thead', {}, h('tr', {}, h('th', {}, 'Symmetry'), h('th', {}, 'Direction'), h('th', {}, 'Residual'))),
      h('tbody', {}, rows)),
    h('p', { class: 'why' }, why(object)),
    createEffects(object.effects),
    object.pose && copyButton('Copy pose', 'Copy the pose of the frame fixed to the object, and its size, as JSON', () => exports.copyPose(object)));
}
