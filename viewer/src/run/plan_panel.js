// The parts of the panel that only a plan has: the legend of the map, and the list of grasps.
import { h, setPressed } from '../dom.js';
import { centimetres, fixed } from '../format.js';
import { css } from '../palette.js';
import { MAPS, shareColor } from './plan.js';

const STATES = { chosen: 'chosen', reached: 'reached', not_reached: 'not reached', not_tried: 'not tried' };
const STEPS = [0, 0.25, 0.5, 0.75, 1];

function createLegend() {
  const ramp = `linear-gradient(90deg, ${STEPS.map((share) => css(shareColor(share))).join(', ')})`;
  return h('div', { class: 'legend' },
    h('div', { class: 'ramp', style: { background: ramp } }),
    h('div', { class: 'ends' }, h('span', {}, 'from nowhere'), h('span', {}, 'half'), h('span', {}, 'all directions')));
}

function createReach({ reach }, { store, actions }) {
  const buttons = MAPS.map(([map, text]) => h('button', { type: 'button', 'data-map': map, onclick: () => actions.setMap(map) }, text));
  store.subscribe((state) => { for (const button of buttons) setPressed(button, state.map === button.dataset.map); });
  return h('section', { class: 'reach', 'aria-label': 'Reach' },
    h('div', { class: 'section-head' }, h('h2', {}, 'Reach')),
    h('div', { class: 'group modes', role: 'group', 'aria-label': 'Map of reach' }, buttons), createLegend(),
    h('p', { class: 'more' }, `Share of directions from which the arm brings its finger tips ${centimetres(reach.height)} cm above the table. ` +
      'From above: closing directions. From the side: directions of approach. Obstacles are not considered.'));
}

function createGrasp(grasp, index, actions) {
  return h('li', {}, h('button', { type: 'button', class: `planned is-${grasp.state}`, 'data-grasp': index, onclick: () => actions.toggleGrasp(index) },
    h('span', { class: 'swatch' }),
    h('span', { class: 'what' }, `Grasp ${grasp.number} of object ${grasp.object}`, h('small', {}, `quality ${fixed(grasp.quality, 2)}`)),
    h('span', { class: 'state' }, STATES[grasp.state]), grasp.reason && h('span', { class: 'why-not' }, grasp.reason)));
}

function createGrasps({ grasps }, { store, actions }) {
  const rows = grasps.map((grasp, index) => createGrasp(grasp, index, actions));
  store.subscribe((state) => rows.forEach((row, index) => setPressed(row.firstChild, state.grasp === index)));
  return h('section', { class: 'plan-grasps', 'aria-label': 'Grasps' },
    h('div', { class: 'section-head' }, h('h2', {}, 'Grasps'), h('span', { class: 'aside' }, String(grasps.length))),
    grasps.length > 0 ? h('ol', { class: 'planned-list' }, rows) : h('p', { class: 'more' }, 'There are none.'));
}

export function createPlanSections(plan, player) {
  return [plan.reach && createReach(plan, player), createGrasps(plan, player)];
}
