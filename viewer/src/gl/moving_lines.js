// Lines that change: the measured distance, and the camera of the frame that is played.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { segments } from './lines.js';

export class MovingLines {
  constructor(color, linewidth) {
    this.material = new LineMaterial({ color: new THREE.Color(color), linewidth, transparent: true, depthTest: false, depthWrite: false });
    this.object = new THREE.Group();
  }

  /** `pairs` are the end points of the lines; none hides them. */
  show(pairs) {
    for (const child of this.object.children) child.geometry.dispose();
    this.object.clear();
    if (pairs.length > 0) this.object.add(segments(pairs, this.material, 9));
  }
}
