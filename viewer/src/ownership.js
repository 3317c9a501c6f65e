// The object that each point is drawn as. Masks may overlap: of the visible objects, the one with the
// highest score owns the point.

export const REST = 0xfffe; // in no mask
export const HIDDEN = 0xffff; // only in masks of hidden objects

/** The owner of every point; `objects` are sorted by falling score. */
export function pointOwners(count, objects, isVisible) {
  const owners = new Uint16Array(count).fill(REST);
  for (let i = objects.length - 1; i >= 0; --i) {
    const owner = isVisible(objects[i].index) ? objects[i].index : HIDDEN;
    for (const point of objects[i].points) {
      if (owner !== HIDDEN || owners[point] === REST) owners[point] = owner;
    }
  }
  return owners;
}
