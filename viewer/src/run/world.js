// The scene of both views: what they share, the true objects, and the believed ones.
import * as THREE from 'three';
import { Bodies } from './bodies.js';
import { ExploreMarks } from './explore_marks.js';
import { frameOf } from './frame.js';
import { PlanMarks } from './plan_marks.js';
import { poseAt } from './track.js';

function createLamp({ center, radius }) {
  const lamp = new THREE.DirectionalLight(0xffffff, 1.9);
  lamp.position.copy(center).add(new THREE.Vector3(-0.55, 1.5, 0.7).multiplyScalar(radius));
  lamp.target.position.copy(center);
  lamp.castShadow = true;
  lamp.shadow.mapSize.set(1024, 1024);
  lamp.shadow.radius = 3;
  lamp.shadow.normalBias = 0.006 * radius;
  const { camera } = lamp.shadow;
  Object.assign(camera, { left: -1.2 * radius, right: 1.2 * radius, top: 1.2 * radius, bottom: -1.2 * radius, near: 0.1 * radius, far: 4 * radius });
  camera.updateProjectionMatrix();
  return [lamp, lamp.target];
}

// What stands beside the table casts its shadow there.
function createFloor({ center, radius, floor }) {
  const plane = new THREE.Mesh(new THREE.PlaneGeometry(8 * radius, 8 * radius).rotateX(-Math.PI / 2), new THREE.ShadowMaterial({ opacity: 0.22 }));
  plane.position.set(center.x, floor, center.z);
  plane.receiveShadow = true;
  return plane;
}

function createMarks({ plan, exploration }) {
  if (exploration) return new ExploreMarks(exploration);
  return plan && new PlanMarks(plan);
}

export class World {
  constructor(recording) {
    this.recording = recording;
    this.bodies = new Bodies();
    this.frame = frameOf(recording);
    this.shared = new THREE.Group();
    this.truth = new THREE.Group();
    this.belief = new THREE.Group();
    this.shownBelief = -1;
    const root = new THREE.Group().add(this.shared, this.truth, this.belief);
    this.marks = createMarks(recording);
    if (this.marks) root.add(this.marks);
    root.applyMatrix4(this.frame.matrix);
    this.scene = new THREE.Scene().add(root, new THREE.HemisphereLight(0xffffff, 0x8f95a3, 1.5), ...createLamp(this.frame), createFloor(this.frame));
    this.moving = recording.solids.filter(({ surface }) => surface).map((solid) => this.#createSolid(solid));
  }

  #createSolid(solid) {
    const mesh = this.bodies.solid(solid, this.recording.objects.indexOf(solid));
    if (this.recording.exploration && solid.kind === 'hand') mesh.castShadow = false; // the camera hangs in the air
    (solid.kind === 'object' ? this.truth : this.shared).add(mesh);
    return { solid, mesh };
  }

  #showBelief(index) {
    if (index === this.shownBelief) return;
    this.shownBelief = index;
    for (const mesh of this.belief.children) mesh.geometry.dispose();
    this.belief.clear();
    if (index < 0) return;
    const numberOf = (object) => this.recording.objects.indexOf(object);
    for (const object of this.recording.believed(index)) {
      if (object.surface) this.belief.add(this.bodies.believed(object, numberOf));
    }
  }

  /** Moves everything to where it is at a time. */
  setTime(time) {
    for (const { solid, mesh } of this.moving) {
      const { position, rotation } = poseAt(solid.track, time);
      mesh.position.set(...position);
      mesh.quaternion.set(...rotation);
    }
    this.#showBelief(this.recording.beliefAt(time));
  }

  /** Shows the true objects or the believed ones. */
  setSide(side) {
    this.truth.visible = side === 'true';
    this.belief.visible = side === 'believed';
  }

  /** Texts at the objects of a side: {at, text}, `at` in the frame of the view. */
  tags(side, time) {
    if (side === 'believed') {
      const objects = this.shownBelief < 0 ? [] : this.recording.believed(this.shownBelief);
      return objects.filter(({ extent }) => extent).map(({ extent, label, name }) => ({
        at: this.frame.point([extent.middle[0], extent.middle[1], extent.high[2]]), text: label || name,
      }));
    }
    return this.moving.filter(({ solid }) => solid.kind === 'object').map(({ solid, mesh }) => ({
      at: new THREE.Vector3(...solid.extent.middle).applyMatrix4(mesh.matrixWorld).setY(this.#topOf(mesh)).toArray(), text: solid.name,
    }));
  }

  #topOf(mesh) {
    return new THREE.Box3().setFromObject(mesh).max.y;
  }
}
