// The solids and believed objects as meshes that are lit and cast shadows.
import * as THREE from 'three';
import { creasedCorners } from '../gl/creases.js';
import { mix, objectColor } from '../palette.js';

const COLORS = {
  light: { robot: [218, 223, 231], hand: [108, 120, 140], bin: [150, 164, 186], table: [222, 217, 209], unknown: [150, 156, 166] },
  dark: { robot: [176, 184, 196], hand: [120, 132, 152], bin: [92, 106, 130], table: [84, 84, 88], unknown: [128, 134, 144] },
};
const UNKNOWN = 'unknown'; // a believed object without a true one
const TINT = 0.6; // share of an object's own colour where its surface has colours

/** Light of a byte of sRGB, from 0 to 1. */
const LINEAR = Float32Array.from({ length: 256 }, (_, byte) => new THREE.Color(`rgb(${byte}, 0, 0)`).r);

/** Per corner the colour of its vertex, mixed with a tint unless that is null. */
function cornerColors({ triangles, colors }, tint) {
  const corners = new Float32Array(3 * triangles.length);
  triangles.forEach((vertex, i) => {
    const own = Array.from(colors.subarray(3 * vertex, 3 * vertex + 3));
    corners.set((tint ? mix(own, tint, TINT) : own).map((byte) => LINEAR[byte]), 3 * i);
  });
  return corners;
}

function geometryOf(surface, tint) {
  const { corners, normals } = creasedCorners(surface);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(corners, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
  if (surface.colors.length > 0) geometry.setAttribute('color', new THREE.BufferAttribute(cornerColors(surface, tint), 3));
  return geometry;
}

export class Bodies {
  constructor() {
    this.scheme = 'light';
    this.materials = new Map();
  }

  /** The material of a kind of solid, or of the object with an index; made once. */
  #material(look, colored) {
    const key = `${look} ${colored}`;
    if (!this.materials.has(key)) {
      const material = new THREE.MeshLambertMaterial({ side: THREE.DoubleSide, vertexColors: colored });
      this.materials.set(key, { material, look, colored });
      this.#paint(this.materials.get(key));
    }
    return this.materials.get(key).material;
  }

  #paint({ material, look, colored }) {
    const rgb = typeof look === 'number' ? objectColor(look) : COLORS[this.scheme][look];
    material.color.setStyle(colored ? '#fff' : `rgb(${rgb.join()})`);
  }

  setScheme(scheme) {
    this.scheme = scheme;
    for (const entry of this.materials.values()) this.#paint(entry);
  }

  #mesh(surface, look) {
    const tint = typeof look === 'number' ? objectColor(look) : null;
    const mesh = new THREE.Mesh(geometryOf(surface, tint), this.#material(look, surface.colors.length > 0));
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    return mesh;
  }

  solid({ surface, kind }, number) {
    return this.#mesh(surface, kind === 'object' ? number : kind);
  }

  believed({ surface, counterpart }, numberOf) {
    return this.#mesh(surface, counterpart ? numberOf(counterpart) : UNKNOWN);
  }
}
