// Which grasps are drawn, and what the page calls their origins and reasons.
import * as format from './format.js';

const SOURCES = {
  axis_side: 'from the side of an axis', axis_top: 'along an axis', rim: 'on the rim', mirror_plane: 'across a mirror plane',
  box_face: 'on faces of a box', antipodal: 'on opposite points', cylinder: 'around a cylinder',
};
const LENGTHS = new Set(['too_wide', 'too_thin', 'table', 'own_shape', 'other_object', 'outside_space']);

export const sourceName = (source) => SOURCES[source] ?? format.words(source);
export const reasonText = (grasps, reason) => grasps.meanings[reason] ?? format.words(reason);

function measure(reason, value) {
  if (!Number.isFinite(value)) return '–';
  if (LENGTHS.has(reason)) return `${format.fixed(1000 * value, 1)} mm`;
  return format.fixed(value, Number.isInteger(value) ? 0 : 3);
}

/** "92.0 mm > 78.0 mm": the value that failed, and its bound. */
export function failure({ reason, value, bound }) {
  const relation = value > bound ? '>' : value < bound ? '<' : '=';
  return `${measure(reason, value)} ${relation} ${measure(reason, bound)}`;
}

/** The grasp of a key: "a3" is the fourth accepted one, "r3" the fourth rejected one. */
export function graspOf(grasps, key) {
  const [, kind, number] = /^([ar])(\d+)$/.exec(key ?? '') ?? [];
  return { a: grasps.accepted, r: grasps.rejected }[kind]?.[Number(number)] ?? null;
}

/** The grasps of an object with their keys, best first. */
export function graspsOfObject(grasps, object, kind) {
  const list = kind === 'a' ? grasps.accepted : grasps.rejected;
  return list.map((grasp, i) => ({ grasp, key: `${kind}${i}` })).filter(({ grasp }) => grasp.object === object);
}

/**
 * The [key, emphasis] of the grasps to draw: the best of every visible object; of a selected object
 * all that are valid, or the chosen one with the others faint.
 */
export function drawnGrasps(grasps, { grasps: on, visible, selected, grasp: chosen, hoveredGrasp }) {
  if (!on) return [];
  if (selected === null || !visible.has(selected)) {
    return [...visible].sort((a, b) => a - b)
      .map((object) => graspsOfObject(grasps, object, 'a')[0])
      .filter(Boolean).map(({ key }) => [key, 'normal']);
  }
  const ofObject = (key) => (graspOf(grasps, key)?.object === selected ? key : null);
  const marked = ofObject(hoveredGrasp) ?? ofObject(chosen);
  const others = graspsOfObject(grasps, selected, 'a').map(({ key }, i) => [key, marked === null && i === 0 ? 'strong' : 'faint']);
  if (marked === null) return others;
  return [...others.filter(([key]) => key !== marked), [marked, 'strong']];
}
