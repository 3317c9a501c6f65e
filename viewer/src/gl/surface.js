// The reconstructed surface as a mesh, lit like the cloud and drawn in the same two passes.
import * as THREE from 'three';
import { emphasisUniforms, setEmphasis } from './emphasis.js';
import { surfaceColorFragment, surfaceDepthFragment, surfaceVertex } from './shaders.js';

function surfaceMaterials() {
  const uniforms = {
    near: { value: 0.1 },
    far: { value: 10 },
    depths: { value: null },
    ...emphasisUniforms(),
  };
  const shared = { vertexShader: surfaceVertex, uniforms, side: THREE.DoubleSide };
  const depth = new THREE.ShaderMaterial({
    ...shared, fragmentShader: surfaceDepthFragment, blending: THREE.NoBlending,
  });
  const color = new THREE.ShaderMaterial({
    ...shared, fragmentShader: surfaceColorFragment, depthTest: false, depthWrite: false, transparent: true,
    blending: THREE.CustomBlending, blendSrc: THREE.OneFactor, blendDst: THREE.OneFactor,
  });
  return { uniforms, depth, color };
}

export class Surface {
  constructor({ positions, triangles }) {
    const count = positions.length / 3;
    this.positions = positions;
    this.shades = new Uint8Array(3 * count);
    this.owners = new Uint16Array(count);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    geometry.computeVertexNormals();
    geometry.setAttribute('shade', new THREE.BufferAttribute(this.shades, 3, true));
    geometry.setAttribute('owner', new THREE.BufferAttribute(this.owners, 1));
    this.normals = geometry.attributes.normal.array;
    this.materials = surfaceMaterials();
    this.object = new THREE.Mesh(geometry, this.materials.depth);
    this.object.userData.layer = this;
    this.object.frustumCulled = false;
  }

  /** ownerOf(vertex) is the index of an object or REST; shadeOf(vertex, owner) an RGB triple of bytes. */
  paint(ownerOf, shadeOf) {
    for (let i = 0; i < this.owners.length; ++i) {
      const owner = ownerOf(i);
      this.owners[i] = owner;
      this.shades.set(shadeOf(i, owner), 3 * i);
    }
    this.object.geometry.attributes.shade.needsUpdate = true;
    this.object.geometry.attributes.owner.needsUpdate = true;
  }

  emphasise(selected, hovered, paper) {
    setEmphasis(this.materials.uniforms, selected, hovered, paper);
  }
}
