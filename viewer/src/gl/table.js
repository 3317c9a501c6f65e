// The table: a grid that fades out, and soft shadows of the objects on it.
import * as THREE from 'three';
import { tableFragment, tableVertex } from './shaders.js';

const TEXELS = 192;
const CELLS = [0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];

function boxBlur(values, size, radius) {
  const result = new Float32Array(values.length);
  const line = (base, stride) => {
    let sum = 0;
    for (let i = -radius; i < size + radius; ++i) {
      if (i + radius < size) sum += values[base + (i + radius) * stride];
      if (i - radius - 1 >= 0) sum -= values[base + (i - radius - 1) * stride];
      if (i >= 0 && i < size) result[base + i * stride] = sum / (2 * radius + 1);
    }
  };
  for (let row = 0; row < size; ++row) line(row * size, 1);
  values.set(result);
  for (let column = 0; column < size; ++column) line(column, size);
  return result;
}

// Blurred density of the points above the table, with a higher weight for low ones.
function shadowTexture(positions, extent) {
  let values = new Float32Array(TEXELS * TEXELS);
  for (let i = 0; i < positions.length; i += 3) {
    const column = Math.floor((positions[i] / extent / 2 + 0.5) * TEXELS);
    const row = Math.floor((positions[i + 2] / extent / 2 + 0.5) * TEXELS);
    if (column < 0 || row < 0 || column >= TEXELS || row >= TEXELS) continue;
    const weight = Math.exp(-Math.max(0, positions[i + 1]) / (0.12 * extent));
    values[row * TEXELS + column] = Math.max(values[row * TEXELS + column], weight);
  }
  for (const radius of [2, 2, 3]) values = boxBlur(values, TEXELS, radius);
  const bytes = Uint8Array.from(values, (value) => Math.min(255, 330 * value));
  const texture = new THREE.DataTexture(bytes, TEXELS, TEXELS, THREE.RedFormat);
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

function horizontalReach(positions) {
  let reach = 0;
  for (let i = 0; i < positions.length; i += 3) {
    reach = Math.max(reach, Math.hypot(positions[i], positions[i + 2]));
  }
  return Math.max(reach, 0.05);
}

export function createTable(positions) {
  const extent = 1.9 * horizontalReach(positions);
  const cell = CELLS.find((size) => extent / size < 26) ?? 10;
  const geometry = new THREE.PlaneGeometry(2 * extent, 2 * extent).rotateX(-Math.PI / 2);
  // Texture rows run along +z, from the far edge to the near one.
  const { uv } = geometry.attributes;
  for (let i = 0; i < uv.count; ++i) uv.setY(i, 1 - uv.getY(i));
  const material = new THREE.ShaderMaterial({
    vertexShader: tableVertex,
    fragmentShader: tableFragment,
    uniforms: {
      shadow: { value: shadowTexture(positions, extent) },
      ink: { value: new THREE.Color() },
      cell: { value: cell },
      extent: { value: extent },
      gridOpacity: { value: 0.2 },
      shadowOpacity: { value: 0.4 },
    },
    transparent: true,
    premultipliedAlpha: true,
    depthWrite: false,
    side: THREE.DoubleSide,
  });
  return { mesh: new THREE.Mesh(geometry, material), cell, uniforms: material.uniforms };
}
