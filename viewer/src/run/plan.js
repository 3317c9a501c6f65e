// A planned motion: its grasps and where the arm reaches. Frame of the table: z up, metres.
import { decodeAs, decodePositions } from '../payload.js';

/** The maps of reach that can be shown: [key, text]. */
export const MAPS = [['above', 'From above'], ['side', 'From the side'], ['off', 'Off']];

// From no direction to all of them; lightness falls, so that it reads without colour too.
const SHARES = [[228, 229, 232], [189, 215, 199], [127, 196, 180], [59, 158, 158], [24, 105, 122]];

/** The colour of a share in [0, 1]. */
export function shareColor(share) {
  const at = Math.min(1, Math.max(0, share)) * (SHARES.length - 1);
  const lower = Math.min(Math.floor(at), SHARES.length - 2);
  return SHARES[lower].map((value, k) => Math.round(value + (SHARES[lower + 1][k] - value) * (at - lower)));
}

function decodeReach({ spacing, height, centers, above, side }) {
  const shares = (bytes) => Array.from(decodeAs(Uint8Array, bytes), (byte) => byte / 255);
  return { spacing, height, centers: decodePositions(centers), above: shares(above), side: shares(side) };
}

/** Null for the page of a run. */
export function decodePlan(plan) {
  return plan ? { ...plan, reach: plan.reach && decodeReach(plan.reach) } : null;
}

const along = (point, direction, length) => point.map((value, k) => value + length * direction[k]);

/** The hand at a grasp as pairs of points: two fingers, the palm, and the way to it. */
export function handLines({ position, closing, approach, opening }, depth) {
  const [left, right] = [along(position, closing, opening / 2), along(position, closing, -opening / 2)];
  return [
    left, along(left, approach, depth), right, along(right, approach, depth), left, right, position, along(position, approach, -depth),
  ];
}

const numberOf = ({ grasps }, ...states) => grasps.filter(({ state }) => states.includes(state)).length;

/** "3 grasps are reached, 5 are not, 12 were not tried" */
export function planSummary(plan) {
  const [reached, missed, untried] = [numberOf(plan, 'chosen', 'reached'), numberOf(plan, 'not_reached'), numberOf(plan, 'not_tried')];
  const parts = [`${reached} of ${plan.grasps.length} grasps reached`, missed > 0 && `${missed} not reached`, untried > 0 && `${untried} not tried`];
  return parts.filter(Boolean).join(' · ');
}
