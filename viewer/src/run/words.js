// Times and outcomes as the page tells them.
import { svg } from '../dom.js';
import { plural } from '../format.js';
import { coverageText, explorationSummary } from './explore.js';
import { planSummary } from './plan.js';

/** 83.41 → "1:23.4" */
export function clock(time) {
  const tenths = Math.round(10 * Math.abs(time));
  const minutes = Math.floor(tenths / 600);
  const rest = ((tenths % 600) / 10).toFixed(1).padStart(4, '0');
  return `${time < 0 && tenths > 0 ? '−' : ''}${minutes}:${rest}`;
}

export const OUTCOMES = { success: 'Success', failure: 'Failure', note: 'Note' };

// Outcomes differ in shape, not only in colour.
const SHAPES = {
  success: () => [svg('circle', { cx: 8, cy: 8, r: 7 }), svg('path', { d: 'M4.800 8.300l2.200 2.200 4.200-4.700' })],
  failure: () => [svg('path', { class: 'body', d: 'M8 .600 15.400 8 8 15.400 .600 8Z' }), svg('path', { d: 'M6 6l4 4M10 6l-4 4' })],
  note: () => [svg('circle', { cx: 8, cy: 8, r: 2.6 })],
};

export function outcomeMark(outcome) {
  return svg('svg', { viewBox: '0 0 16 16', class: `mark is-${outcome}`, 'aria-hidden': 'true' }, ...SHAPES[outcome]());
}

const numberOf = (events, outcome) => events.filter((event) => event.outcome === outcome).length;

const picked = ({ objects, left }) => Math.max(0, objects.length - left.length);

/** "2 of 6 picked": until a time. That a whole run succeeded is an event too, which picks no object. */
export function progress(recording, time) {
  if (recording.exploration) return coverageText(recording.exploration, time);
  if (recording.plan) return '';
  const successes = numberOf(recording.events.filter((event) => event.time <= time), 'success');
  return `${Math.min(successes, picked(recording))} of ${recording.objects.length} picked`;
}

/** "Picked 4 of 6 objects in 83 s · 2 failures" */
export function summary(recording) {
  if (recording.exploration) return explorationSummary(recording.exploration);
  if (recording.plan) return planSummary(recording.plan);
  const { objects, events, begin, end } = recording;
  const parts = [`Picked ${picked(recording)} of ${plural(objects.length, 'object')} in ${(end - begin).toFixed(end - begin < 10 ? 1 : 0)} s`];
  const failures = numberOf(events, 'failure');
  if (failures > 0) parts.push(plural(failures, 'failure'));
  return parts.join(' · ');
}
