// The state of the player, and what the controls do to it.
import { createStore } from '../store.js';
import { lastNotAfter } from './track.js';

export const SPEEDS = [0.5, 1, 2, 4, 8];
const VIEWS = ['both', 'true', 'believed'];
const STEP_BACK = 0.5; // while it plays, "previous" goes past events that were this short ago [s]

/** The views that a recording has: of a planned motion there is only one. */
export const viewsOf = ({ plan }) => (plan ? ['true'] : VIEWS);

export const initialState = (recording) => ({
  time: recording.begin, playing: false, speed: 1, views: viewsOf(recording)[0], labels: true,
  map: 'above', // of reach
  grasp: null, // the index of the chosen one of a plan
  candidate: null, // the number of the chosen view of an exploration
});

export function createPlayerState(recording) {
  const { begin, end, events } = recording;
  const store = createStore(initialState(recording));
  const clamped = (time) => Math.min(end, Math.max(begin, time));
  const eventTimes = events.map(({ time }) => clamped(time));
  const actions = {
    seek: (time) => { if (Number.isFinite(time)) store.set({ time: clamped(time) }); },
    play() {
      const { time } = store.get();
      store.set({ time: time >= end ? begin : time, playing: end > begin });
    },
    pause: () => store.set({ playing: false }),
    toggle: () => (store.get().playing ? actions.pause() : actions.play()),
    /** Lets `elapsed` seconds of the watch pass. */
    advance(elapsed) {
      const { time, speed } = store.get();
      const next = clamped(time + speed * elapsed);
      store.set({ time: next, playing: next < end });
    },
    setSpeed: (speed) => { if (SPEEDS.includes(speed)) store.set({ speed }); },
    changeSpeed(step) {
      const index = SPEEDS.indexOf(store.get().speed) + step;
      if (SPEEDS[index]) store.set({ speed: SPEEDS[index] });
    },
    goToEvent: (index) => actions.seek(eventTimes[index]),
    nextEvent() {
      const index = lastNotAfter(eventTimes, store.get().time) + 1;
      actions.seek(index < eventTimes.length ? eventTimes[index] : end);
    },
    previousEvent() {
      const { time, playing, speed } = store.get();
      const limit = playing ? time - STEP_BACK * speed : time;
      const earlier = eventTimes.filter((each) => each < limit);
      actions.seek(earlier.length > 0 ? earlier[earlier.length - 1] : begin);
    },
    setViews: (views) => { if (viewsOf(recording).includes(views)) store.set({ views }); },
    setMap: (map) => store.set({ map }),
    toggleGrasp: (index) => store.set({ grasp: store.get().grasp === index ? null : index }),
    toggleCandidate: (candidate) => store.set({ candidate: store.get().candidate === candidate ? null : candidate }),
    toggleLabels: () => store.set({ labels: !store.get().labels }),
  };
  return { store, actions, currentEvent: (time) => lastNotAfter(eventTimes, time) };
}
