// The fitted surface of an object as lines: a box, a regular prism, a cylinder or a sphere.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { closed, segments } from './lines.js';
import { css, mix } from '../palette.js';
import { add, scale } from '../vector.js';

const ROUND = 64; // lines of a circle

const sizeOf = (shape, name) => {
  const found = shape.dimensions.find((dimension) => dimension.name === name);
  return found && (found.value ?? found.at_least);
};

// Corners of a regular polygon about the third axis, at a height over the centre. The first side
// of a prism faces along the first axis.
function ring({ center, axes }, radius, height, corners, phase = 0) {
  return Array.from({ length: corners }, (_, i) => {
    const a = phase + (2 * Math.PI * i) / corners;
    const across = add(scale(axes[0], radius * Math.cos(a)), scale(axes[1], radius * Math.sin(a)));
    return add(center, add(across, scale(axes[2], height)));
  });
}

function boxLines({ center, axes, ...shape }) {
  const half = ['length', 'width', 'height'].map((name) => sizeOf(shape, name) / 2);
  const corner = (i) => [1, 2, 4].reduce(
    (p, bit, k) => add(p, scale(axes[k], i & bit ? half[k] : -half[k])), center);
  return [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) =>
    [1, 2, 4].filter((bit) => !(i & bit)).map((bit) => [corner(i), corner(i | bit)]));
}

function standingLines(shape, radius, corners, risers, phase) {
  const half = sizeOf(shape, 'height') / 2;
  const [low, high] = [-half, half].map((height) => ring(shape, radius, height, corners, phase));
  const step = corners / risers;
  const upright = low.filter((_, i) => i % step === 0).map((p, i) => [p, high[i * step]]);
  return [...closed(low), ...closed(high), ...upright];
}

function sphereLines({ center, axes, ...shape }) {
  const radius = sizeOf(shape, 'radius');
  return [0, 1, 2].flatMap((k) => {
    const turned = { center, axes: [axes[(k + 1) % 3], axes[(k + 2) % 3], axes[k]] };
    return closed(ring(turned, radius, 0, ROUND));
  });
}

/** The lines of a class with dimensions, as pairs of points; none without. */
export function shapeLines(shape) {
  if (!shape || shape.dimensions.length === 0) return [];
  if (shape.name === 'box') return boxLines(shape);
  if (shape.name === 'sphere') return sphereLines(shape);
  if (shape.name === 'cylinder') return standingLines(shape, sizeOf(shape, 'radius'), ROUND, 4, 0);
  const { order } = shape;
  const corner = sizeOf(shape, 'apothem') / Math.cos(Math.PI / order);
  return standingLines(shape, corner, order, order, Math.PI / order);
}

export class Shape {
  constructor(object, color) {
    this.color = color;
    const line = (linewidth, opacity, depthTest) => new LineMaterial({
      color: new THREE.Color(css(color)), linewidth, opacity, transparent: true, depthTest, depthWrite: false,
    });
    this.materials = [line(1.6, 0.5, false), line(3, 1, true)];
    const lines = shapeLines(object.shape);
    this.isEmpty = lines.length === 0;
    this.object = new THREE.Group();
    if (!this.isEmpty) this.object.add(...this.materials.map((material, i) => segments(lines, material, 6 + i)));
  }

  setScheme(scheme) {
    const target = scheme === 'dark' ? [255, 255, 255] : [0, 0, 0];
    for (const material of this.materials) material.color.set(css(mix(this.color, target, 0.5)));
  }
}
