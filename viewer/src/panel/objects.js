// The list of objects with visibility, number and score; the selected object shows its details.
import { h, setPressed } from '../dom.js';
import * as format from '../format.js';
import { icon } from '../icons.js';
import { css, inkOn, objectColor } from '../palette.js';
import { objectDetails } from './details.js';
import { createGraspList, graspSummary } from './grasps.js';

export function symmetrySummary({ rotational, reflectional }) {
  const parts = [];
  if (rotational.length) parts.push(rotational.length === 1 ? '1 axis' : `${rotational.length} axes`);
  if (reflectional.length) parts.push(format.plural(reflectional.length, 'plane'));
  return parts.join(' · ') || 'no symmetry';
}

// A row has no room for both symmetries and grasps; the details of the object list both.
const summary = (object, { grasps }) => (grasps ? graspSummary(grasps, object.index) : symmetrySummary(object));

const iconButton = (name, title, onclick, extra = '') =>
  h('button', { class: `icon-button ${extra}`, type: 'button', title, 'aria-label': title, onclick }, icon(name));

function scoreMeter(score) {
  const share = Math.min(1, Math.max(0, Number(score) || 0));
  return h('span', { class: 'score', title: `Score ${format.fixed(score, 3)} of 1` },
    h('span', { class: 'meter' }, h('span', { style: { width: `${100 * share}%` } })),
    h('span', { class: 'number' }, format.fixed(score, 2)));
}

function createRow(object, scene, store, actions, extentOf, exports) {
  const { name } = object;
  const { index } = object;
  const eye = iconButton('eye', `Show or hide ${name}`, () => actions.toggleVisible(index), 'eye');
  const completed = iconButton('completed', `Completed ${name}`, () => actions.toggleCompleted(index));
  const solo = iconButton('solo', `Show only ${name}`, () => actions.solo(index));
  if (!object.hasCompletion) completed.disabled = true;
  const select = h('button', { class: 'pick', type: 'button', 'aria-expanded': 'false', onclick: () => actions.toggleSelect(index) },
    h('span', { class: 'badge' }, String(object.id)),
    h('span', { class: 'name' }, name, h('small', { title: summary(object, scene) }, summary(object, scene))),
    scoreMeter(object.score));
  const details = h('div', { class: 'details', hidden: true });
  const color = objectColor(index);
  const row = h('li', {
    class: 'object', style: { '--color': css(color), '--on-color': inkOn(color) },
    onpointerenter: (event) => actions.hoverWith(event, index), onpointerleave: () => actions.hover(null),
  }, h('div', { class: 'row' }, eye, select, completed, solo), details);
  const open = (isOpen) => {
    if (isOpen && !details.firstChild) {
      details.append(objectDetails(object, scene, extentOf(index), exports));
      if (scene.grasps) details.append(createGraspList(object, scene.grasps, store, actions));
    }
    details.hidden = !isOpen;
  };
  return { object, row, eye, eyeOff: icon('eyeOff'), eyeOn: eye.firstChild, completed, solo, select, open };
}

function updateRow(entry, state, actions) {
  const { index } = entry.object;
  const visible = state.visible.has(index);
  const selected = state.selected === index;
  entry.row.classList.toggle('off', !visible);
  entry.row.classList.toggle('selected', selected);
  entry.row.classList.toggle('hovered', state.hovered === index);
  entry.eye.replaceChildren(visible ? entry.eyeOn : entry.eyeOff);
  setPressed(entry.eye, visible);
  setPressed(entry.completed, state.completed.has(index));
  setPressed(entry.solo, actions.isSolo(index));
  entry.select.setAttribute('aria-expanded', String(selected));
  entry.open(selected);
}

export function createObjectList(scene, store, actions, extentOf, exports) {
  const rows = scene.objects.map((object) => createRow(object, scene, store, actions, extentOf, exports));
  const chip = (text, onclick) => h('button', { class: 'chip', type: 'button', onclick }, text);
  const section = h('section', { class: 'objects', 'aria-label': format.words(`${scene.noun}s`) },
    h('div', { class: 'section-head' }, h('h2', {}, format.words(`${scene.noun}s`)),
      h('div', { class: 'chips' }, chip('All', actions.showAll), chip('None', actions.showNone))),
    h('ul', {}, rows.map(({ row }) => row)));
  store.subscribe((state, changed) => {
    for (const entry of rows) updateRow(entry, state, actions);
    if (changed.has('selected') && state.selected !== null) {
      rows[state.selected].row.scrollIntoView({ block: 'nearest' });
    }
  });
  return section;
}
