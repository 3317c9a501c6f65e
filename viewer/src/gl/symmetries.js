// Reflection planes as bordered sheets and rotation axes as arrows, sized to their object.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { closed, group, quadrilateral, segments } from './lines.js';
import { css, mix } from '../palette.js';
import { add, cross, dot, planeBasis, quantile, scale, subtract } from '../vector.js';

const UP = [0, 1, 0];

// Materials shared by an object's symmetries, in its colour: in front of and behind the surface.
function createMaterials(color) {
  const rgb = new THREE.Color(css(color));
  const line = (linewidth, opacity, depthTest) =>
    new LineMaterial({ color: rgb, linewidth, opacity, transparent: true, depthTest, depthWrite: false });
  return {
    border: line(1.6, 0.9, true),
    borderBehind: line(1.2, 0.22, false),
    axis: line(2.6, 1, true),
    axisBehind: line(2, 0.4, false),
    sheet: new THREE.MeshBasicMaterial({
      color: rgb, transparent: true, opacity: 0.13, side: THREE.DoubleSide, depthWrite: false,
    }),
    cap: new THREE.MeshBasicMaterial({ color: rgb }),
  };
}

function extentAlong(points, origin, direction) {
  const values = points.map((p) => dot(subtract(p, origin), direction));
  return [quantile(values, 0.005), quantile(values, 0.995)];
}

function planeObject(plane, points, materials) {
  const [u, v] = planeBasis(plane.normal, UP);
  const [u0, u1] = extentAlong(points, plane.point, u);
  const [v0, v1] = extentAlong(points, plane.point, v);
  const margin = 0.09 * Math.max(u1 - u0, v1 - v0) + 0.006;
  const corner = (a, b) => add(plane.point, add(scale(u, a), scale(v, b)));
  const corners = [
    corner(u0 - margin, v0 - margin), corner(u1 + margin, v0 - margin),
    corner(u1 + margin, v1 + margin), corner(u0 - margin, v1 + margin),
  ];
  const sheet = quadrilateral(corners, materials.sheet, 1);
  const border = closed(corners);
  return group(sheet, segments(border, materials.borderBehind, 2), segments(border, materials.border, 3));
}

// An arc of three quarters of a turn about the axis, which marks a rotational symmetry.
function turn(center, direction, radius) {
  const [u, v] = planeBasis(direction, [0, 0, 1]);
  const at = (angle) => add(center, add(scale(u, radius * Math.cos(angle)), scale(v, radius * Math.sin(angle))));
  const steps = 36;
  return Array.from({ length: steps }, (_, i) => [
    at((1.6 * Math.PI * i) / steps), at((1.6 * Math.PI * (i + 1)) / steps),
  ]);
}

function cone(tip, direction, size, material) {
  const mesh = new THREE.Mesh(new THREE.ConeGeometry(0.36 * size, size, 24), material);
  mesh.position.set(...subtract(tip, scale(direction, size / 2)));
  mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), new THREE.Vector3(...direction));
  return mesh;
}

function axisObject(axis, points, materials) {
  const direction = axis.direction[1] < 0 ? scale(axis.direction, -1) : axis.direction;
  const at = (t) => add(axis.point, scale(direction, t));
  const [t0, t1] = extentAlong(points, axis.point, direction);
  const radius = quantile(points.map((p) => Math.hypot(...cross(subtract(p, axis.point), direction))), 0.8);
  const margin = 0.14 * (t1 - t0) + 0.018;
  const size = Math.min(Math.max(0.3 * radius, 0.009), 0.03);
  const line = [[at(t0 - 0.6 * margin), at(t1 + margin)]];
  const circle = turn(at(t1 + 0.5 * margin), direction, Math.min(Math.max(0.42 * radius, 0.01), 0.035));
  return group(
    segments(line, materials.axisBehind, 4),
    segments([...line, ...circle], materials.axis, 5),
    cone(at(t1 + margin + size), direction, size, materials.cap),
  );
}

/** Points that bound an object: a sample of its observed and its completed points. */
export function outlinePoints(cloud, object, limit = 1200) {
  const sample = [];
  const take = (positions, total, indexOf) => {
    const step = Math.max(1, Math.floor(total / limit));
    for (let k = 0; k < total; k += step) {
      const i = 3 * indexOf(k);
      sample.push([positions[i], positions[i + 1], positions[i + 2]]);
    }
  };
  take(cloud.positions, object.points.length, (k) => object.points[k]);
  take(object.completed.positions, object.completed.count, (k) => k);
  return sample;
}

export class Symmetries {
  constructor(object, outline, color) {
    this.color = color;
    this.materials = createMaterials(color);
    this.setScheme('light', [255, 255, 255]);
    this.planes = new THREE.Group();
    this.axes = new THREE.Group();
    for (const plane of object.planes) this.planes.add(planeObject(plane, outline, this.materials));
    for (const axis of object.axes) this.axes.add(axisObject(axis, outline, this.materials));
  }

  /** Lines must stand out from the background: lighter on a dark one, darker on a light one. */
  setScheme(scheme, paper) {
    const target = scheme === 'dark' ? [255, 255, 255] : [0, 0, 0];
    this.lineColor = mix(this.color, target, scheme === 'dark' ? 0.3 : 0.12);
    this.paper = paper;
    for (const material of Object.values(this.materials)) material.color.set(css(this.lineColor));
  }

  show(planes, axes, emphasis) {
    this.planes.visible = planes;
    this.axes.visible = axes;
    const strength = { normal: 1, strong: 1.7, faint: 0.35 }[emphasis];
    const { sheet, border, borderBehind, axis, axisBehind, cap } = this.materials;
    sheet.opacity = 0.13 * strength;
    border.opacity = Math.min(1, 0.75 * strength);
    borderBehind.opacity = Math.min(0.5, 0.2 * strength);
    axisBehind.opacity = Math.min(0.7, 0.4 * strength);
    // Paler instead of transparent, because overlaps of the arc's pieces would show.
    const pale = mix(this.lineColor, this.paper, emphasis === 'faint' ? 0.6 : 0);
    for (const material of [axis, cap]) material.color.set(css(pale));
  }
}
