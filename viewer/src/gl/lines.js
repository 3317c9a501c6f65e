// Lines several pixels wide, and shapes built from them.
import * as THREE from 'three';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/** One object of many lines; `pairs` are their end points. */
export function segments(pairs, material, order) {
  const geometry = new LineSegmentsGeometry().setPositions(pairs.flat(2));
  const lines = new LineSegments2(geometry, material);
  lines.renderOrder = order;
  return lines;
}

export const closed = (corners) => corners.map((corner, i) => [corner, corners[(i + 1) % corners.length]]);

export function group(...children) {
  const result = new THREE.Group();
  result.add(...children);
  return result;
}

/** A flat quadrilateral. */
export function quadrilateral(corners, material, order) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(corners.flat()), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const sheet = new THREE.Mesh(geometry, material);
  sheet.renderOrder = order;
  return sheet;
}
