// Objects of the ground truth, each with the found object that overlaps it most.

function intersection(a, b) {
  let count = 0;
  for (let i = 0, k = 0; i < a.length && k < b.length;) {
    if (a[i] === b[k]) { ++count; ++i; ++k; } else if (a[i] < b[k]) ++i;
    else ++k;
  }
  return count;
}

/** Intersection over union of two ascending lists; 0 for empty ones. */
export function overlap(a, b) {
  const common = intersection(a, b);
  return common / Math.max(1, a.length + b.length - common);
}

const FOUND = 0.5; // the least overlap of an object that counts as found

/** Per true object: its name, number of points, and the best found object with its overlap, or null. */
export function compareWithTruth(truth, objects) {
  return truth.map(({ name, points }) => {
    const overlaps = objects.map((object) => ({ index: object.index, overlap: overlap(points, object.points) }));
    const best = overlaps.sort((a, b) => b.overlap - a.overlap)[0];
    return { name, points: points.length, best: best && best.overlap > 0 ? best : null, isFound: Boolean(best) && best.overlap >= FOUND };
  });
}

/** The true object that a found one overlaps most, or null. */
export function truthOf(truth, { points }) {
  const overlaps = truth.map((object) => ({ name: object.name, overlap: overlap(object.points, points) }));
  const best = overlaps.sort((a, b) => b.overlap - a.overlap)[0];
  return best && best.overlap > 0 ? best : null;
}
