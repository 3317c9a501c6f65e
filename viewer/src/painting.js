// Colours of points: of the scan, of the object, or a mix; grey for points without colour.
import { NO_POINT } from './coverage.js';
import { HIDDEN, REST, pointOwners } from './ownership.js';
import { lighter, mix, objectColor } from './palette.js';

const PLAIN = { light: [176, 181, 190], dark: [150, 156, 166] };
const AROUND = { blend: 0.35, objects: 1 }; // greyness of the surface around the objects
const HEIGHTEN = 1.12; // compensates for the shading of discs, which darkens colours that are already lit

const brighten = (value) => Math.min(255, Math.round(value * HEIGHTEN));

function scanColor(colors, i, plain) {
  if (colors.length === 0) return plain;
  return [brighten(colors[3 * i]), brighten(colors[3 * i + 1]), brighten(colors[3 * i + 2])];
}

// The object's hue with the lightness of the scan, so that print and edges stay legible.
function blend(scan, color) {
  const grey = 0.3 * scan[0] + 0.59 * scan[1] + 0.11 * scan[2];
  const tinted = color.map((value) => Math.min(255, value * (0.72 + grey / 700)));
  return mix(scan, tinted, 0.74);
}

function restColor(scan, mode, plain) {
  if (mode === 'scan') return scan;
  return mix(scan, plain, mode === 'objects' ? 1 : 0.6);
}

const ownersNow = (cloud, objects, state) => pointOwners(cloud.count, objects, (index) => state.visible.has(index));
const paletteOf = (objects) => objects.map((object) => objectColor(object.index));

const MISSED = 12; // where the colours of true objects begin that no found one overlaps

/** Per point the colour of its true object, or null: that of the found object which overlaps it most. */
export function trueColors(count, truth, compared) {
  const colors = new Array(count).fill(null);
  truth.forEach(({ points }, i) => {
    const { best } = compared[i];
    const color = objectColor(best ? best.index : MISSED + i);
    points.forEach((point) => { colors[point] = color; });
  });
  return colors;
}

/** `covered` marks the points that the drawn surface shows. */
export function paintCloud(splats, cloud, objects, state, scheme, covered) {
  const owners = ownersNow(cloud, objects, state);
  if (!state.rest) owners.forEach((owner, i) => { if (owner === REST) owners[i] = HIDDEN; });
  const palette = paletteOf(objects);
  const plain = PLAIN[scheme];
  splats.paint(owners, (i, owner) => {
    if (owner === HIDDEN) return plain;
    if (state.mode === 'truth') return cloud.trueColors[i] ?? plain;
    const scan = scanColor(cloud.colors, i, plain);
    if (owner === REST) return restColor(scan, state.mode, plain);
    if (state.mode === 'scan') return scan;
    return state.mode === 'objects' || cloud.colors.length === 0 ? palette[owner] : blend(scan, palette[owner]);
  }, covered);
}

/** Vertices take the owner of their `nearest` point; those without one, and those of hidden objects,
 * count as surroundings. */
export function paintSurface(drawn, { colors }, nearest, cloud, objects, state, scheme) {
  const owners = ownersNow(cloud, objects, state);
  const palette = paletteOf(objects);
  const plain = PLAIN[scheme];
  const ownerOf = (i) => {
    const owner = nearest[i] === NO_POINT ? REST : owners[nearest[i]];
    return owner === HIDDEN ? REST : owner;
  };
  drawn.paint(ownerOf, (i, owner) => {
    const scan = scanColor(colors, i, plain);
    if (state.mode === 'scan') return scan;
    if (state.mode === 'truth') return (nearest[i] !== NO_POINT && cloud.trueColors[nearest[i]]) || mix(scan, plain, AROUND.objects);
    if (owner === REST) return mix(scan, plain, AROUND[state.mode]);
    return state.mode === 'objects' || colors.length === 0 ? palette[owner] : blend(scan, palette[owner]);
  });
}

/** A closed surface: inferred vertices, which are black in the payload, are lighter. */
export function paintClosed(drawn, { index, closed }) {
  const color = objectColor(index);
  const inferred = lighter(color);
  drawn.paint(() => index, (i) => (closed.colors[3 * i] > 127 ? color : inferred));
}

export function paintCompleted(splats, object) {
  const color = lighter(objectColor(object.index));
  splats.paint(new Uint16Array(object.completed.count).fill(object.index), () => color);
}
