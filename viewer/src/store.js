// The state of the controls. Views subscribe to its changes.
import { withMark } from './measure.js';

export function createStore(initial) {
  let state = initial;
  const listeners = new Set();
  return {
    get: () => state,
    set(patch) {
      const changed = Object.keys(patch).filter((key) => state[key] !== patch[key]);
      if (changed.length === 0) return;
      state = { ...state, ...patch };
      for (const listener of listeners) listener(state, new Set(changed));
    },
    subscribe(listener) {
      listeners.add(listener);
      listener(state, new Set(Object.keys(state)));
    },
  };
}

export function initialState({ objects, surface, grasps, views, table }) {
  return {
    mode: objects.length ? 'blend' : 'scan',
    visible: new Set(objects.map((object) => object.index)),
    completed: new Set(),
    selected: null,
    hovered: null,
    // Grippers between the sheets would be hard to see, and without a table walls have sheets that
    // hide what stands before them.
    planes: !grasps && Number.isFinite(table),
    axes: true,
    labels: true,
    rest: true,
    mesh: Boolean(surface),
    path: false,
    grasps: Boolean(grasps),
    grasp: null, // the key of the chosen one
    hoveredGrasp: null,
    views: Boolean(views),
    view: null, // the rank of the chosen one
    hoveredView: null,
    rejection: null, // the number of the shown rejected hypothesis
    measure: false,
    marks: [], // of the measured distance, in the display frame
    moment: null, // the number of the frame of the sweep that is shown
    playing: false,
  };
}

const toggled = (set, value) => {
  const copy = new Set(set);
  if (!copy.delete(value)) copy.add(value);
  return copy;
};

/** The user's actions, shared by all controls. */
export function createActions(store, objects) {
  const all = () => new Set(objects.map((object) => object.index));
  const state = store.get;
  const isSolo = (index) => state().visible.size === 1 && state().visible.has(index);
  return {
    isSolo,
    select: (index) => store.set({ selected: index }),
    toggleSelect: (index) => store.set({ selected: state().selected === index ? null : index }),
    hover: (index) => store.set({ hovered: index }),
    // A touch does not end a hover, so that the mark would stay.
    hoverWith: (event, index) => { if (event.pointerType === 'mouse') store.set({ hovered: index }); },
    toggleVisible: (index) => store.set({ visible: toggled(state().visible, index) }),
    solo: (index) => store.set({ visible: isSolo(index) ? all() : new Set([index]) }),
    showAll: () => store.set({ visible: all() }),
    showNone: () => store.set({ visible: new Set() }),
    toggleCompleted: (index) => store.set({ completed: toggled(state().completed, index) }),
    toggleAllCompleted: () => store.set({ completed: state().completed.size ? new Set() : all() }),
    toggle: (key) => store.set({ [key]: !state()[key] }),
    toggleGrasp: (key) => store.set({ grasp: state().grasp === key ? null : key, grasps: true }),
    hoverGrasp: (key) => store.set({ hoveredGrasp: key }),
    hoverGraspWith: (event, key) => { if (event.pointerType === 'mouse') store.set({ hoveredGrasp: key }); },
    toggleView: (rank) => store.set({ view: state().view === rank ? null : rank, views: true }),
    hoverView: (rank) => store.set({ hoveredView: rank }),
    hoverViewWith: (event, rank) => { if (event.pointerType === 'mouse') store.set({ hoveredView: rank }); },
    setMode: (mode) => store.set({ mode }),
    toggleRejection: (number) => store.set({ rejection: state().rejection === number ? null : number, selected: null }),
    toggleMeasure: () => store.set({ measure: !state().measure, marks: [] }),
    mark: (position) => store.set({ marks: withMark(state().marks, position) }),
    setMoment: (moment) => store.set({ moment }),
    togglePlaying: () => store.set({ playing: !state().playing, moment: state().moment ?? 0 }),
  };
}
