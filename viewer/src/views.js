// Views that the camera could take next, by descending gain.

/** The share of the greatest gain that a view has, in [0, 1]. */
export function gainShare({ list }, rank) {
  const most = list[0].gain;
  return most > 0 ? Math.max(0, list[rank].gain) / most : 0;
}
