// The uniforms by which the layers of the scene set off objects and fade the others.
import * as THREE from 'three';

export const emphasisUniforms = () => ({
  selected: { value: -1 },
  hovered: { value: -1 },
  paper: { value: new THREE.Color(1, 1, 1) },
});

/** `selected` and `hovered` are indices of objects, or null; `paper` is the background's RGB triple of bytes. */
export function setEmphasis(uniforms, selected, hovered, paper) {
  uniforms.selected.value = selected ?? -1;
  uniforms.hovered.value = hovered ?? -1;
  uniforms.paper.value.setRGB(...paper.map((value) => value / 255));
}
