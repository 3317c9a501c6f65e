// The lists beside the view: models with their progress, and the symmetries of the current model.
import { h, setPressed } from '../dom.js';
import { css } from '../palette.js';
import { nameOf } from './models.js';

export const KEYS = [
  ['A', 'accept'], ['R', 'reject'], ['U', 'leave open'], ['Shift A', 'accept all open ones of the model'],
  ['↑ ↓', 'symmetry'], ['← →', 'model'], ['M', 'moved copy on or off'], ['S', 'save the choices'], ['H F T', 'home, front, top view'],
];

export function createModelList(models, choices, onPick) {
  const rows = models.map(({ name, symmetries }, index) => {
    const dot = h('span', { class: 'dot' });
    const done = h('span', { class: 'done' });
    const button = h('button', { class: 'model', onclick: () => onPick(index), title: name },
      dot, h('span', { class: 'title' }, name), done);
    return { button, dot, done, count: symmetries.length };
  });
  const update = (current) => rows.forEach(({ button, dot, done, count }, index) => {
    const decided = choices.decided(index);
    button.setAttribute('aria-current', String(index === current));
    done.textContent = count === 0 ? 'none' : `${decided}/${count}`;
    dot.className = `dot ${decided === count ? 'complete' : decided > 0 ? 'begun' : ''}`;
    if (index === current) button.scrollIntoView({ block: 'nearest' });
  });
  return { element: h('nav', { class: 'models', 'aria-label': 'Models' }, rows.map(({ button }) => button)), update };
}

const residualText = ({ residual_mm: mm, residual_percent: percent }) =>
  `residual ${mm.toFixed(2)} mm, ${percent.toFixed(2)} % of the diagonal`;

function createCard(symmetry, color, actions) {
  const choose = (value) => (event) => { event.stopPropagation(); actions.choose(value); };
  const accept = h('button', { class: 'accept', onclick: choose(true) }, 'Accept');
  const reject = h('button', { class: 'reject', onclick: choose(false) }, 'Reject');
  const element = h('li', { class: 'symmetry', style: { '--color': css(color) }, onclick: actions.select },
    h('div', { class: 'what' }, nameOf(symmetry)),
    h('div', { class: 'residual' }, residualText(symmetry)),
    h('div', { class: 'choices' }, accept, reject));
  return { element, accept, reject };
}

export function createSide(choices, actions) {
  const element = h('aside', { class: 'side', 'aria-label': 'Symmetries' });
  let cards = [];
  const keys = h('dl', { class: 'keys' }, KEYS.flatMap(([key, text]) => [h('dt', {}, key), h('dd', {}, text)]));

  function show(model, index) {
    cards = model.symmetries.map((symmetry, s) => createCard(symmetry, model.shown[s].color, {
      select: () => actions.select(s),
      choose: (value) => actions.choose(s, choices.get(index, s) === value ? null : value),
    }));
    element.replaceChildren(h('h2', {}, model.name),
      h('p', { class: 'facts' }, `diameter ${model.diameter_mm.toFixed(1)} mm, diagonal ${model.diagonal_mm.toFixed(1)} mm`),
      cards.length ? h('ul', {}, cards.map((card) => card.element))
        : h('p', { class: 'none' }, 'No symmetry was found within the tolerance.'),
      keys);
  }

  function update(index, selected) {
    cards.forEach((card, s) => {
      const value = choices.get(index, s);
      card.element.setAttribute('aria-current', String(s === selected));
      card.element.classList.toggle('rejected', value === false);
      setPressed(card.accept, value === true);
      setPressed(card.reject, value === false);
      if (s === selected) card.element.scrollIntoView({ block: 'nearest' });
    });
  }
  return { element, show, update };
}

export function createBar(title, choices, { onSave, onLoad }) {
  const fill = h('span');
  const text = h('p');
  const file = h('input', { type: 'file', accept: '.json,application/json', hidden: true, onchange: () => { if (file.files[0]) onLoad(file.files[0]); file.value = ''; } });
  const element = h('header', { class: 'bar' }, h('h1', {}, title),
    h('div', { class: 'progress', role: 'status' }, h('div', { class: 'track' }, fill), text),
    file,
    h('button', { class: 'button load', onclick: () => file.click() }, 'Continue from a file'),
    h('button', { class: 'button primary save', onclick: onSave }, 'Save choices', h('kbd', {}, 'S')));
  const update = () => {
    const decided = choices.decidedOfAll();
    fill.style.width = `${choices.total ? (100 * decided) / choices.total : 100}%`;
    text.textContent = `${decided} of ${choices.total} symmetries reviewed`;
  };
  return { element, update };
}
