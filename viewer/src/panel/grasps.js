// The grasps of an object as a list, and the counts of a whole scene.
import { h, setPressed } from '../dom.js';
import * as format from '../format.js';
import { failure, graspsOfObject, reasonText, sourceName } from '../grasps.js';
import { css, qualityColor } from '../palette.js';

const MOST_ROWS = 20;

const mark = (color) => h('span', { class: 'quality', style: { '--color': css(color) } });
const millimetres = (length) => `${format.fixed(1000 * length, 0)} mm`;

/** How many grasps an object has, or why none: the name of the reason, which fits its row. */
export function graspSummary(grasps, index) {
  const { grasps: count, reason } = grasps.objects[index];
  if (count > 0) return format.plural(count, 'grasp');
  return reason ? `no grasp: ${format.words(reason).toLowerCase()}` : 'no grasp';
}

function heading(grasps, { grasps: count, reason }) {
  if (count > 0) return format.plural(count, 'grasp');
  return reason ? `No grasp: ${reasonText(grasps, reason)}` : 'No grasp';
}

function graspButton({ key, grasp }, actions, ...content) {
  return h('button', {
    class: 'grasp', type: 'button', 'data-grasp': key, onclick: () => actions.toggleGrasp(key),
    onpointerenter: (event) => actions.hoverGraspWith(event, key), onpointerleave: () => actions.hoverGrasp(null),
  }, content);
}

function acceptedRow(entry, actions) {
  const { quality, opening, source } = entry.grasp;
  return h('li', {}, graspButton(entry, actions,
    mark(qualityColor(quality)), h('span', { class: 'number' }, format.fixed(quality, 2)),
    h('span', { class: 'source' }, sourceName(source)), h('span', { class: 'number' }, millimetres(opening))));
}

const rejectedRow = (entry, actions) =>
  h('li', {}, graspButton(entry, actions, mark([138, 144, 154]), h('span', { class: 'source' }, sourceName(entry.grasp.source)),
    h('span', { class: 'number' }, failure(entry.grasp))));

function createRows(entries, total, row, actions) {
  const list = h('ul', { class: 'grasps' }, entries.slice(0, MOST_ROWS).map((entry) => row(entry, actions)));
  const rest = total - Math.min(entries.length, MOST_ROWS);
  return [list, rest > 0 && h('p', { class: 'more' }, `and ${format.count(rest)} more`)];
}

const byCount = (counts) => Object.entries(counts).sort((a, b) => b[1] - a[1] || a[0].localeCompare(b[0]));

function rejectedGroup(grasps, [reason, count], entries, actions) {
  return h('details', { class: 'reason' },
    h('summary', {}, h('span', {}, format.words(reason), h('small', {}, reasonText(grasps, reason))),
      h('span', { class: 'aside' }, format.count(count))),
    createRows(entries, count, rejectedRow, actions));
}

/** The list in the details of an object. Buttons follow the state as long as the page lives. */
export function createGraspList(object, grasps, store, actions) {
  const summary = grasps.objects[object.index];
  const accepted = graspsOfObject(grasps, object.index, 'a');
  const rejected = graspsOfObject(grasps, object.index, 'r');
  const element = h('section', { class: 'object-grasps', 'aria-label': `Grasps: ${object.name}` },
    h('h3', {}, heading(grasps, summary)),
    createRows(accepted, summary.grasps, acceptedRow, actions),
    byCount(summary.rejected).length > 0 && h('h3', {}, `Rejected, of ${format.plural(summary.candidates, 'candidate')}`),
    byCount(summary.rejected).map((group) =>
      rejectedGroup(grasps, group, rejected.filter(({ grasp }) => grasp.reason === group[0]), actions)));
  const buttons = [...element.querySelectorAll('[data-grasp]')];
  store.subscribe(({ grasp }) => {
    for (const button of buttons) setPressed(button, button.dataset.grasp === grasp);
    buttons.find((button) => button.dataset.grasp === grasp)?.closest('details')?.setAttribute('open', '');
  });
  return element;
}

function totals({ objects }) {
  const rejected = {};
  for (const summary of objects) {
    for (const [reason, count] of Object.entries(summary.rejected)) rejected[reason] = (rejected[reason] ?? 0) + count;
  }
  const sum = (key) => objects.reduce((total, summary) => total + summary[key], 0);
  return { candidates: sum('candidates'), grasps: sum('grasps'), graspable: objects.filter((s) => s.grasps > 0).length, rejected };
}

function qualityScale() {
  const stops = [0, 0.25, 0.5, 0.75, 1].map((quality) => css(qualityColor(quality)));
  return h('div', { class: 'quality-scale' }, h('span', {}, 'Quality 0'),
    h('span', { class: 'ramp', style: { background: `linear-gradient(to right, ${stops.join(', ')})` } }), h('span', {}, '1'));
}

function reasonRow(grasps, [reason, count], most) {
  const share = Math.log1p(count) / Math.log1p(most);
  return h('tr', {}, h('th', { scope: 'row' }, format.words(reasonText(grasps, reason))),
    h('td', { class: 'bar' }, h('span', { style: { width: `${100 * share}%` } })),
    h('td', { class: 'number' }, format.count(count)));
}

/** The section of the whole scene: the gripper, its grasps, and the rejected candidates by reason. */
export function createGraspSection({ grasps, objects, noun }) {
  if (!grasps) return null;
  const { candidates, grasps: count, graspable, rejected } = totals(grasps);
  const reasons = byCount(rejected);
  return h('details', { class: 'grasp-section', open: true },
    h('summary', {}, 'Grasps', h('span', { class: 'aside' }, `${graspable} of ${format.plural(objects.length, noun)}`)),
    h('p', { class: 'more' }, `Gripper ${grasps.gripper.name}, which opens ${millimetres(grasps.gripper.max_opening)}: ` +
      `${format.plural(count, 'grasp')} of ${format.plural(candidates, 'candidate')}.` +
      (count > 0 ? ` The best of each ${noun} is drawn; select one for all of its grasps.` : '')),
    qualityScale(),
    reasons.length > 0 && h('h3', {}, 'Rejected candidates by reason (log scale)'),
    reasons.length > 0 && h('table', { class: 'bars' }, h('tbody', {}, reasons.map((entry) => reasonRow(grasps, entry, reasons[0][1])))));
}
