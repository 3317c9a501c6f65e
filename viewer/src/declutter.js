// Places labels near their anchors so that none covers another.

const OFFSETS = (() => {
  const offsets = [];
  // Aslant first: straight up is where a rotation axis leaves its object.
  for (const distance of [34, 50, 70, 94, 122, 156, 196]) {
    for (const angle of [38, -38, 60, -60, 15, -15, 80, -80, 100, -100]) {
      const a = (angle * Math.PI) / 180;
      offsets.push([distance * Math.sin(a), -distance * Math.cos(a)]);
    }
  }
  return offsets;
})();

export const overlaps = (a, b, gap = 0) =>
  a.left < b.right + gap && b.left < a.right + gap && a.top < b.bottom + gap && b.top < a.bottom + gap;

const within = (box, area) =>
  box.left >= area.left && box.right <= area.right && box.top >= area.top && box.bottom <= area.bottom;

function boxAt(x, y, { width, height }) {
  return { left: x - width / 2, right: x + width / 2, top: y - height / 2, bottom: y + height / 2 };
}

/**
 * For each of `labels` ({x, y, width, height}, the anchor and the size) the centre of its box, or
 * null where there is no room. Earlier ones choose first; anchors of all are kept free.
 */
export function placeLabels(labels, area, obstacles) {
  const taken = [...obstacles];
  const anchors = labels.map(({ x, y }) => boxAt(x, y, { width: 8, height: 8 }));
  return labels.map((label, index) => {
    const foreign = anchors.filter((_, i) => i !== index);
    const fits = (box, blockers, gap) =>
      within(box, area) && !blockers.some((other) => overlaps(box, other, gap));
    const candidates = OFFSETS.map(([dx, dy]) => [label.x + dx, label.y + dy]);
    const at = ([x, y]) => boxAt(x, y, label);
    const place = candidates.find((c) => fits(at(c), taken, 4) && fits(at(c), foreign, 0)) ??
      candidates.find((c) => fits(at(c), taken, 2));
    if (!place) return null;
    taken.push(at(place));
    return { x: place[0], y: place[1] };
  });
}
