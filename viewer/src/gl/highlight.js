// The points of a rejected hypothesis as round marks over the scene, faint where something hides them.
import * as THREE from 'three';

const COLOR = [214, 30, 130];
const OF_SIZE = 4.33; // three.js sizes points for a view of 90°; this view has 26°

function disc() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const context = canvas.getContext('2d');
  context.fillStyle = '#fff';
  context.arc(16, 16, 15, 0, 2 * Math.PI);
  context.fill();
  return new THREE.CanvasTexture(canvas);
}

export class Highlight {
  constructor(size) {
    const map = disc();
    const material = (opacity, depthTest) => new THREE.PointsMaterial({
      color: new THREE.Color(`rgb(${COLOR.join(', ')})`), size: OF_SIZE * size, map, alphaTest: 0.3, transparent: true, opacity, depthTest, depthWrite: false,
    });
    this.geometry = new THREE.BufferGeometry();
    this.object = new THREE.Group();
    for (const each of [material(0.3, false), material(1, true)]) {
      const points = new THREE.Points(this.geometry, each);
      points.frustumCulled = false;
      points.renderOrder = 8;
      this.object.add(points);
    }
    this.object.visible = false;
  }

  /** `positions` of the points to mark; none hides the marks. */
  show(positions) {
    this.object.visible = positions.length > 0;
    this.geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(positions), 3));
  }
}
