// The views that the camera could take next, best first.
import { h, setPressed } from '../dom.js';
import * as format from '../format.js';
import { css, qualityColor } from '../palette.js';
import { gainShare } from '../views.js';

const MOST_ROWS = 12;
const PARTS = [['inferred', 'inferred surface'], ['disputed', 'disputed surface'], ['unknown', 'unknown space'], ['cost', 'cost']];

const amount = (value, unit) => `${format.fixed(value, unit === 'voxels' ? 0 : 1)} ${unit}`;

function partsText(view, unit) {
  const parts = PARTS.filter(([key]) => view[key] > 0);
  return parts.map(([key, text]) => `${text} ${amount(view[key], unit)}`).join(', ');
}

function viewRow(views, rank, actions) {
  const view = views.list[rank];
  return h('li', {}, h('button', {
    class: 'grasp', type: 'button', 'data-view-rank': String(rank), title: partsText(view, views.unit),
    onclick: () => actions.toggleView(rank),
    onpointerenter: (event) => actions.hoverViewWith(event, rank), onpointerleave: () => actions.hoverView(null),
  }, h('span', { class: 'quality', style: { '--color': css(qualityColor(gainShare(views, rank))) } }),
  h('span', { class: 'source' }, `View ${view.candidate}`),
  h('span', { class: 'number' }, amount(view.gain, views.unit))));
}

function explanation({ policy, is_enough: isEnough }) {
  const what = policy === 'symmetry'
    ? 'Surface that a view is expected to show: inferred and not seen yet, or claimed by competing hypotheses, and the border of unknown space, weighted.'
    : `Voxels that a view is expected to show, by the policy ${policy}.`;
  return isEnough ? `${what} No view is expected to show much more.` : what;
}

/** The section of a scene whose next view is to be chosen. */
export function createViewSection({ views }, store, actions) {
  if (!views) return null;
  const { list } = views;
  const rows = list.slice(0, MOST_ROWS).map((_, rank) => viewRow(views, rank, actions));
  const parts = h('p', { class: 'more' });
  const element = h('details', { class: 'view-section', open: true },
    h('summary', {}, 'Next view', h('span', { class: 'aside' }, format.plural(list.length, 'candidate'))),
    h('p', { class: 'more' }, explanation(views)),
    h('ul', { class: 'grasps' }, rows), parts);
  const buttons = [...element.querySelectorAll('[data-view-rank]')];
  store.subscribe(({ view }) => {
    for (const button of buttons) setPressed(button, button.dataset.viewRank === String(view));
    const chosen = list[view ?? 0];
    parts.textContent = chosen ? `View ${chosen.candidate}: ${partsText(chosen, views.unit) || 'nothing new'}.` : '';
  });
  return element;
}
