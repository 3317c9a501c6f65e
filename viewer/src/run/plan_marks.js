// What the page of a plan draws beside the motion: the map of reach on the table, and the hand at each grasp.
import * as THREE from 'three';
import { handLines, shareColor } from './plan.js';

const ABOVE_TABLE = 0.001; // of the map, which lies on it [m]
const GAP = 0.94; // edge of a drawn cell, by its spacing
const COLORS = { chosen: '#1864ab', reached: '#2b8a3e', not_reached: '#c92a2a', not_tried: '#868e96' };

function colored(rgb) {
  return new THREE.Color(`rgb(${rgb.join()})`);
}

function createMap({ spacing, centers }, shares) {
  const cell = new THREE.PlaneGeometry(GAP * spacing, GAP * spacing);
  const material = new THREE.MeshBasicMaterial({ polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 });
  const map = new THREE.InstancedMesh(cell, material, shares.length);
  shares.forEach((share, i) => {
    map.setMatrixAt(i, new THREE.Matrix4().makeTranslation(centers[3 * i], centers[3 * i + 1], ABOVE_TABLE));
    map.setColorAt(i, colored(shareColor(share)));
  });
  map.frustumCulled = false;
  return map;
}

function createHand(grasp, depth) {
  const points = handLines(grasp, depth).map((point) => new THREE.Vector3(...point));
  const material = new THREE.LineBasicMaterial({ color: COLORS[grasp.state] });
  return new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points), material);
}

/** A group in the frame of the table. */
export class PlanMarks extends THREE.Group {
  constructor({ grasps, finger_depth: depth, reach }) {
    super();
    this.maps = reach ? { above: createMap(reach, reach.above), side: createMap(reach, reach.side) } : {};
    this.hands = grasps.map((grasp) => createHand(grasp, depth));
    this.add(...Object.values(this.maps), ...this.hands);
  }

  /** Shows one map, or none, and the hand at one grasp, or at all. */
  show({ map, grasp }) {
    for (const [key, mesh] of Object.entries(this.maps)) mesh.visible = key === map;
    this.hands.forEach((hand, index) => { hand.visible = grasp === null || grasp === index; });
  }
}
