// Entry point of the page of a live scene: shows the newest update, or the one that the user chose.
import { h } from '../dom.js';
import { LiveControls } from './controls.js';
import { LivePanel } from './panel.js';
import { LiveView } from './scene.js';
import { LiveSource } from './source.js';

const { title } = JSON.parse(document.getElementById('payload').textContent);
const [view, panel, controls, source] = [new LiveView(), new LivePanel(title), new LiveControls(), new LiveSource(location.href)];
const state = { oldest: 1, newest: 0, wanted: 0, shown: 0, following: true, budget: 20000, shownBudget: 20000, connection: 'waiting', error: null };

document.body.append(h('main', { class: 'views-area' }, view.element), panel.element, controls.element);
view.attach();

const RETRY = 1000; // ms
let isFetching = false;
let run = null; // of the command; another one has other numbers and another frame

const isCurrent = () => state.wanted === state.shown && state.budget === state.shownBudget;

// One request at a time: a slow page skips updates, it does not queue them.
async function refresh() {
  if (isFetching) return;
  isFetching = true;
  try {
    while (!isCurrent()) {
      const [number, budget, begin] = [state.wanted, state.budget, performance.now()];
      const update = await source.fetch(number, budget);
      if (update) show(number, budget, update, (performance.now() - begin) / 1000);
      else if (number < state.oldest) state.wanted = state.oldest;
      else throw new Error('the server does not keep it any more');
    }
    state.error = null;
  } catch (error) {
    state.error = String(error?.message ?? error);
    setTimeout(refresh, RETRY);
  }
  isFetching = false;
  panel.setError(state.error);
}

function show(number, budget, update, received) {
  Object.assign(state, { shown: number, shownBudget: budget });
  const isNew = state.following && state.connection === 'live' && number === state.newest;
  view.show(update);
  panel.show(update, isNew ? received : null);
  controls.show(state);
}

source.onState = (connection) => {
  state.connection = connection;
  panel.setState(connection);
};

source.onReport = ({ run: of, report, oldest }) => {
  if (run !== null && run !== of) location.reload();
  run = of;
  Object.assign(state, { oldest, newest: report.update });
  if (state.following) state.wanted = report.update;
  panel.addChanges(report);
  controls.show({ ...state, shown: state.shown || report.update });
  refresh();
};

function seek(number) {
  state.following = false;
  state.wanted = Math.max(state.oldest, Math.min(state.newest, number));
  controls.show({ ...state, shown: state.wanted });
  refresh();
}

controls.onSeek = seek;
controls.onFollow = () => {
  state.following = !state.following;
  if (state.following) state.wanted = state.newest;
  controls.show(state);
  refresh();
};
controls.onBudget = (budget) => {
  state.budget = budget;
  refresh();
};

source.listen();

// For tests and scripts.
window.symscene = {
  get state() { return { ...state }; },
  get drawn() { return view.requested === 0 && view.frames > 0 && !isFetching; },
  get labels() { return view.tags.shown.map(({ text }) => text); },
  seek,
};
