// Entry point of the review page: decodes the models, connects lists, view, keys and choices.
import { h } from '../dom.js';
import { createChoices } from './choices.js';
import { decodeModel } from './models.js';
import { createBar, createModelList, createSide } from './panels.js';
import { View } from './view.js';

const COPY_HINT = 'Orange: the model moved by the selected symmetry, where it sticks out by more than 1 % of its size.';

function save(choices) {
  const text = `${JSON.stringify(choices.toJson(), null, 1)}\n`;
  const address = URL.createObjectURL(new Blob([text], { type: 'application/json' }));
  h('a', { href: address, download: 'choices.json' }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
  choices.markSaved();
}

function createReview({ title, models: payload }) {
  const choices = createChoices(payload);
  const state = { model: 0, selected: null, copied: true };
  const decoded = new Map(); // models are decoded when they are first shown
  const model = (index) => decoded.get(index) ?? decoded.set(index, decodeModel(payload[index])).get(index);
  const view = new View();
  const hint = h('p', { class: 'hint' }, COPY_HINT);
  view.element.append(hint);

  function update() {
    view.update({ ...state, rejected: (s) => choices.get(state.model, s) === false });
    hint.hidden = !state.copied || state.selected === null;
    list.update(state.model);
    side.update(state.model, state.selected);
    bar.update();
  }
  function select(s) { state.selected = s; update(); }
  function goTo(index) {
    if (index < 0 || index >= payload.length) return;
    state.model = index;
    const { symmetries } = payload[index];
    const open = symmetries.findIndex((_, s) => choices.get(index, s) === null);
    state.selected = symmetries.length === 0 ? null : Math.max(open, 0);
    view.show(model(index));
    side.show(model(index), index);
    update();
  }
  // The next open symmetry of the model, or else of the next model that has one.
  function advance() {
    const isOpen = (m) => (_, s) => choices.get(m, s) === null;
    const here = payload[state.model].symmetries.findIndex(isOpen(state.model));
    if (here >= 0) return select(here);
    for (let step = 1; step < payload.length; ++step) {
      const m = (state.model + step) % payload.length;
      if (payload[m].symmetries.some(isOpen(m))) return goTo(m);
    }
    return update();
  }
  function choose(s, value) {
    if (s === null) return;
    choices.set(state.model, s, value);
    if (value === null) select(s);
    else advance();
  }
  function acceptAll() {
    payload[state.model].symmetries.forEach((_, s) => { if (choices.get(state.model, s) === null) choices.set(state.model, s, true); });
    advance();
  }
  function step(by) {
    const count = payload[state.model].symmetries.length;
    if (count > 0) select((state.selected + by + count) % count);
  }
  async function load(file) {
    try {
      const taken = choices.load(JSON.parse(await file.text()));
      hint.textContent = `${taken} choices of ${file.name} were taken.`;
    } catch (error) {
      hint.textContent = `${file.name} cannot be read: ${error.message}`;
    }
    update();
    hint.hidden = false;
  }

  const list = createModelList(payload, choices, goTo);
  const side = createSide(choices, { select, choose });
  const bar = createBar(title, choices, { onSave: () => save(choices), onLoad: load });
  document.body.append(bar.element, list.element, view.element, side.element);
  const scheme = matchMedia('(prefers-color-scheme: dark)');
  view.scheme = scheme.matches ? 'dark' : 'light';
  scheme.addEventListener('change', () => view.setScheme(scheme.matches ? 'dark' : 'light'));
  view.attach();

  const keys = {
    a: () => choose(state.selected, true), r: () => choose(state.selected, false), u: () => choose(state.selected, null),
    ArrowUp: () => step(-1), ArrowDown: () => step(1),
    ArrowLeft: () => goTo(state.model - 1), ArrowRight: () => goTo(state.model + 1),
    m: () => { state.copied = !state.copied; hint.textContent = COPY_HINT; update(); }, s: () => save(choices),
    h: () => view.viewpoint.go('home'), f: () => view.viewpoint.go('front'), t: () => view.viewpoint.go('top'),
  };
  addEventListener('keydown', (event) => {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = key === 'a' && event.shiftKey ? acceptAll : keys[key];
    if (event.ctrlKey || event.metaKey || event.altKey || !action) return;
    event.preventDefault();
    if (!(event.repeat && 'arus'.includes(key))) action();
  });
  addEventListener('beforeunload', (event) => { if (!choices.isSaved()) event.preventDefault(); });
  if (payload.length > 0) goTo(0);
  window.symscene = {
    ready: new Promise((resolve) => {
      const check = () => (view.frames >= 2 || payload.length === 0 ? resolve(true) : requestAnimationFrame(check));
      check();
      view.invalidate();
    }),
    get model() { return payload[state.model]?.name ?? null; },
    get selected() { return state.selected; },
    get choices() { return choices.toJson(); },
    get frames() { return view.frames; },
    pixels() {
      view.draw();
      return view.canvas.toDataURL().length;
    },
  };
}

try {
  createReview(JSON.parse(document.getElementById('payload').textContent));
} catch (error) {
  document.body.append(h('div', { class: 'failure', role: 'alert' },
    h('strong', {}, 'The models cannot be drawn.'), h('p', {}, String(error?.message ?? error)),
    h('p', {}, 'A browser with WebGL 2 is needed.')));
  throw error;
}
