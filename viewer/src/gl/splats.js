// A point cloud drawn as discs on its surface.
import * as THREE from 'three';
import { emphasisUniforms, setEmphasis } from './emphasis.js';
import { HIDDEN } from '../ownership.js';
import { colorFragment, depthFragment, splatVertex } from './shaders.js';
import { quantile } from '../vector.js';

/** Typical distance from a point to its fourth neighbour, which measures the sampling density. */
export function sampleSpacing(positions) {
  const total = positions.length / 3;
  const probes = Math.min(total, 4e7 / Math.max(total, 1), 200);
  const distances = [];
  for (let k = 0; k < probes; ++k) {
    const i = 3 * Math.floor((k * total) / probes);
    const best = [Infinity, Infinity, Infinity, Infinity];
    for (let j = 0; j < positions.length; j += 3) {
      const d = (positions[j] - positions[i]) ** 2 + (positions[j + 1] - positions[i + 1]) ** 2 +
        (positions[j + 2] - positions[i + 2]) ** 2;
      if (d > 0 && d < best[3]) best.splice(best.findIndex((b) => d < b), 0, d), best.pop();
    }
    if (Number.isFinite(best[3])) distances.push(Math.sqrt(best[3]));
  }
  return quantile(distances, 0.5) || 0.005;
}

// Both passes share their uniforms; the stage fills in those that depend on the view.
function splatMaterials(radius) {
  const uniforms = {
    radius: { value: radius },
    focal: { value: 1000 },
    near: { value: 0.1 },
    far: { value: 10 },
    depths: { value: null },
    ...emphasisUniforms(),
  };
  const depth = new THREE.ShaderMaterial({
    vertexShader: splatVertex, fragmentShader: depthFragment, uniforms, blending: THREE.NoBlending,
  });
  const color = new THREE.ShaderMaterial({
    vertexShader: splatVertex, fragmentShader: colorFragment, uniforms,
    depthTest: false, depthWrite: false, transparent: true,
    blending: THREE.CustomBlending, blendSrc: THREE.OneFactor, blendDst: THREE.OneFactor,
  });
  return { uniforms, depth, color };
}

export class Splats {
  constructor({ positions, normals }, radius) {
    const count = positions.length / 3;
    this.positions = positions;
    this.shades = new Uint8Array(3 * count);
    this.owners = new Uint16Array(count); // owners for picking
    this.drawn = new Uint16Array(count); // owners for drawing; HIDDEN if the surface shows the point
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    const oriented = normals.length === positions.length ? normals : new Float32Array(3 * count);
    geometry.setAttribute('normal', new THREE.BufferAttribute(oriented, 3));
    geometry.setAttribute('shade', new THREE.BufferAttribute(this.shades, 3, true));
    geometry.setAttribute('owner', new THREE.BufferAttribute(this.drawn, 1));
    this.materials = splatMaterials(radius);
    this.object = new THREE.Points(geometry, this.materials.depth);
    this.object.userData.layer = this;
    this.object.frustumCulled = false;
  }

  /** shadeOf(point, owner) is an RGB triple of bytes. Points that are `covered` are not drawn. */
  paint(owners, shadeOf, covered = null) {
    this.owners.set(owners);
    this.drawn.set(owners);
    covered?.forEach((isCovered, i) => { if (isCovered) this.drawn[i] = HIDDEN; });
    for (let i = 0; i < owners.length; ++i) this.shades.set(shadeOf(i, owners[i]), 3 * i);
    this.object.geometry.attributes.shade.needsUpdate = true;
    this.object.geometry.attributes.owner.needsUpdate = true;
  }

  emphasise(selected, hovered, paper) {
    setEmphasis(this.materials.uniforms, selected, hovered, paper);
  }
}
