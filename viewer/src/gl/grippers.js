// Grippers at grasps: palm and fingers as solids with edges, in the colour of their quality.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { segments } from './lines.js';
import { css, mix, qualityColor } from '../palette.js';
import { cross } from '../vector.js';

const REJECTED = [138, 144, 154];
// Palms are paler than fingers, because they would hide the objects.
const LOOKS = {
  strong: { palm: 0.6, finger: 1, width: 2, edge: 1, behind: 0.45 }, // edges also behind the surface
  normal: { palm: 0.2, finger: 0.85, width: 1.3, edge: 0.8, behind: 0 },
  faint: { palm: 0.02, finger: 0.12, width: 1, edge: 0.2, behind: 0 },
};
const EDGES = [0, 1, 2, 3].flatMap((i) => {
  const next = (i + 1) % 4;
  return [[i, next], [4 + i, 4 + next], [i, 4 + i]];
});
const FACES = [[3, 2, 1, 0], [4, 5, 6, 7], ...[0, 1, 2, 3].map((i) => [i, (i + 1) % 4, 4 + ((i + 1) % 4), 4 + i])];

/** A solid between two rectangles of four corners each, the second farther along z. */
function solid(corners) {
  const triangles = FACES.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(triangles.flatMap((i) => corners[i])), 3));
  geometry.computeVertexNormals();
  return { geometry, edges: EDGES.map(([a, b]) => [corners[a], corners[b]]) };
}

const rectangle = ([x0, x1], [y0, y1], z) => [[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]];

function palmSolid([width, length, height]) {
  const at = (z) => rectangle([-width / 2, width / 2], [-length / 2, length / 2], z);
  return solid([...at(-height), ...at(0)]);
}

// Its pad lies in y = 0; it tapers to the tip.
function fingerSolid(gripper, side) {
  const { finger_width: width, finger_thickness: thick, tip_thickness: tip, finger_depth: depth } = gripper;
  const at = (outer, z) => rectangle([-width / 2, width / 2], side > 0 ? [0, outer] : [-outer, 0], z);
  return solid([...at(thick, 0), ...at(tip, depth)]);
}

/** The parts of a gripper whose pads are `opening` apart, or as far as they go: solids and where they stand. */
export function gripperParts(gripper, opening) {
  const y = Math.min(opening, gripper.max_opening) / 2;
  const spread = gripper.kind === 'three_finger' ? gripper.finger_spacing / 2 : 0;
  const upper = spread ? [[-spread, y, 0], [spread, y, 0]] : [[0, y, 0]];
  return [
    { part: 'palm', at: [0, 0, 0] },
    ...upper.map((at) => ({ part: 'positive', at })),
    { part: 'negative', at: [0, -y, 0] },
  ];
}

/** Columns x, y, z and origin of the tool in the display frame. */
function toolMatrix({ position, closing, approach }) {
  const x = new THREE.Vector3(...cross(closing, approach));
  return new THREE.Matrix4()
    .makeBasis(x, new THREE.Vector3(...closing), new THREE.Vector3(...approach))
    .setPosition(...position);
}

export class Grippers {
  constructor(grasps) {
    this.grasps = grasps;
    this.object = new THREE.Group();
    const { gripper } = grasps;
    this.solids = { palm: palmSolid(gripper.palm_size), positive: fingerSolid(gripper, 1), negative: fingerSolid(gripper, -1) };
    const front = new THREE.DirectionalLight(0xffffff, 1.7);
    front.position.set(0.4, 1, 0.8);
    this.lights = [new THREE.HemisphereLight(0xffffff, 0x8088a0, 2), front];
    this.looks = new Map();
  }

  /** Materials of a colour and an emphasis, made once. */
  #look(color, emphasis) {
    const key = `${color} ${emphasis}`;
    if (!this.looks.has(key)) {
      const { palm, finger, width, edge, behind } = LOOKS[emphasis];
      const fill = (opacity) => new THREE.MeshLambertMaterial({
        color: css(color), opacity, transparent: opacity < 1, depthWrite: opacity === 1, flatShading: true,
      });
      const line = (opacity, depthTest) => new LineMaterial({
        color: new THREE.Color(css(mix(color, [0, 0, 0], 0.45))), linewidth: width, opacity, transparent: true, depthTest, depthWrite: false,
      });
      this.looks.set(key, {
        palm: fill(palm),
        finger: fill(finger),
        lines: [line(edge, true), ...(behind ? [line(behind, false)] : [])],
      });
    }
    return this.looks.get(key);
  }

  #build(grasp, emphasis) {
    const color = grasp.reason === undefined ? qualityColor(grasp.quality) : REJECTED;
    const { palm, finger, lines } = this.#look(color, emphasis);
    const tool = new THREE.Group();
    for (const { part, at } of gripperParts(this.grasps.gripper, grasp.opening)) {
      const { geometry, edges } = this.solids[part];
      const children = [new THREE.Mesh(geometry, part === 'palm' ? palm : finger), ...lines.map((line) => segments(edges, line, 8))];
      children.forEach((child) => child.position.set(...at));
      tool.add(...children);
    }
    tool.applyMatrix4(toolMatrix(grasp));
    return tool;
  }

  /** `shown` are [grasp, emphasis]; replaces what was shown before. */
  show(shown) {
    for (const { children } of this.object.children) {
      children.filter((child) => child.isLineSegments2).forEach((child) => child.geometry.dispose());
    }
    this.object.clear();
    this.object.add(...this.lights, ...shown.map(([grasp, emphasis]) => this.#build(grasp, emphasis)));
  }
}
