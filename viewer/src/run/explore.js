// An exploration: views that were taken, what is known after each, and which could follow. Frame of the table: z up, metres.
import { fixed, percent, plural } from '../format.js';
import { decodeDepth } from '../payload.js';
import { lastNotAfter } from './track.js';

/** Null for the page of a run. */
export function decodeExploration(exploration) {
  if (!exploration) return null;
  const views = exploration.views.map((view) => ({ ...view, depth: decodeDepth(view.depth) }));
  const times = views.map(({ time }) => time);
  return {
    ...exploration,
    views,
    /** The number of the view that was taken last at a time; the first before it. */
    stepAt: (time) => Math.max(0, lastNotAfter(times, time)),
  };
}

/** "12.3 cm²" */
export const gainText = (value, unit) => `${fixed(value, unit === 'voxels' ? 0 : 1)} ${unit}`;

const coverage = ({ observed, completed }) => `${percent(observed)} seen, ${percent(completed)} completed`;

/** "8 views · 5 objects · 94 % seen, 98 % completed" */
export function explorationSummary({ views }) {
  const last = views[views.length - 1];
  return [plural(views.length, 'view'), plural(last.objects, 'object'), coverage(last)].join(' · ');
}

/** What is known at a time, for the caption of the true scene. */
export const coverageText = ({ views, stepAt }, time) => coverage(views[stepAt(time)]);

/** "after view 3 of 8: 5 objects" */
export function knownText({ views, stepAt }, time) {
  const step = stepAt(time);
  return `after view ${step + 1} of ${views.length}: ${plural(views[step].objects, 'object')}`;
}

/** Where a share after a view lies in a chart of this size, with the first view at its left edge. */
export function chartPoint(step, share, views, { width, height }) {
  return [views > 1 ? (step / (views - 1)) * width : 0, (1 - Math.min(1, Math.max(0, share))) * height];
}
