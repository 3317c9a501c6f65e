// The camera's path as a line, and a few cameras on it as viewing pyramids.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { group, quadrilateral, segments } from './lines.js';
import { pyramid } from './pyramid.js';
import { css } from '../palette.js';

const DEPTH = 0.05; // of a pyramid [m]
const SLOPE = [0.55, 0.42]; // half its width and height at unit depth

function pathPairs(path) {
  const pairs = [];
  for (let i = 3; i < path.length; i += 3) {
    pairs.push([[...path.subarray(i - 3, i)], [...path.subarray(i, i + 3)]]);
  }
  return pairs;
}

export class Trajectory {
  constructor({ path, cameras }) {
    const line = (linewidth, opacity, depthTest) =>
      new LineMaterial({ linewidth, opacity, transparent: true, depthTest, depthWrite: false });
    const sheet = (opacity) => new THREE.MeshBasicMaterial({
      transparent: true, opacity, side: THREE.DoubleSide, depthWrite: false,
    });
    this.materials = {
      path: line(2.4, 1, true), behind: line(1.6, 0.25, false), edge: line(1.4, 0.9, true),
      first: sheet(0.7), others: sheet(0.16),
    };
    const pyramids = cameras.map((camera) => pyramid(camera, SLOPE, DEPTH));
    const pairs = pathPairs(path);
    this.object = group(
      ...(pairs.length ? [segments(pairs, this.materials.behind, 2), segments(pairs, this.materials.path, 3)] : []),
      segments(pyramids.flatMap(({ edges }) => edges), this.materials.edge, 3),
      ...pyramids.map(({ frame }, i) => quadrilateral(frame, i ? this.materials.others : this.materials.first, 2)));
  }

  setColor(color) {
    for (const material of Object.values(this.materials)) material.color.set(css(color));
  }
}
