// Entry point of the page of a live scene: shows the newest update, or the one that the user chose.
import { h } from '../dom.js';
import { LiveControls } from './controls.js';
import { LivePanel } from './panel.js';
import { LiveView } from './scene.js';
import { LiveSource } from './source.js';

const { title } = JSON.parse(document.getElementById('payload').textContent);
const [view, panel, controls, source] = [new LiveView(), new LivePanel(title), new LiveControls(), new LiveSource(location.href)];
const state = { oldest: 1, newest: 0, wanted: 0, shown: 0, following: true, budget: 20000, connection: 'waiting', error: null };

document.body.append(h('main', { class: 'views-area' }, view.element), panel.element, controls.element);
view.attach();

let isFetching = false;

// One request at a time: a slow page skips updates, it does not queue them.
async function refresh() {
  if (isFetching) return;
  isFetching = true;
  try {
    while (state.wanted !== state.shown) {
      const [number, begin] = [state.wanted, performance.now()];
      const update = await source.fetch(number, state.budget);
      if (!update) state.wanted = Math.max(state.oldest, Math.min(state.newest, number + 1));
      if (!update && state.wanted === number) break;
      if (update) show(number, update, (performance.now() - begin) / 1000);
    }
    state.error = null;
  } catch (error) {
    state.error = String(error?.message ?? error); // the next update tries again
  }
  isFetching = false;
}

function show(number, update, received) {
  state.shown = number;
  view.show(update);
  panel.show(update, received);
  controls.show(state);
}

source.onState = (connection) => {
  state.connection = connection;
  panel.setState(connection);
};

source.onReport = ({ report, oldest }) => {
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
  state.shown = 0;
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
