// What the page of an exploration draws beside the objects: the views that were taken, in grey, and those that could follow,
// by their gain.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { segments } from '../gl/lines.js';
import { pyramid } from '../gl/pyramid.js';
import { DEPTH, Views } from '../gl/views.js';

const TAKEN = '#6b7280';
const NEXT = '#1864ab'; // the view that follows

function outline({ camera }, halfSize, color, linewidth) {
  const material = new LineMaterial({ color, linewidth, transparent: true, depthWrite: false });
  return segments(pyramid(camera, halfSize, DEPTH).edges, material, 4);
}

/** A group in the frame of the table. */
export class ExploreMarks extends THREE.Group {
  constructor({ views, stepAt }) {
    super();
    this.stepAt = stepAt;
    this.lists = views.map(({ next }) => next.list.map(({ candidate }) => candidate));
    this.candidates = views.map(({ next }) => (next.list.length > 0 ? new Views(next) : null));
    this.taken = views.map(({ view, next }) => outline(view, next.half_size, TAKEN, 1.5));
    this.following = views.slice(1).map(({ view, next }) => outline(view, next.half_size, NEXT, 3));
    this.add(...this.taken, ...this.following, ...this.candidates.filter(Boolean).map(({ object }) => object));
  }

  /** Shows the views up to a time, and those that could follow then, one of them strongly. */
  show({ time, candidate }) {
    const step = this.stepAt(time);
    this.taken.forEach((mark, index) => { mark.visible = index <= step; });
    this.following.forEach((mark, index) => { mark.visible = index === step; });
    this.candidates.forEach((views, index) => {
      const rank = index === step && candidate !== null ? this.lists[index].indexOf(candidate) : -1;
      views?.show({ views: index === step, view: rank < 0 ? null : rank, hoveredView: null });
    });
  }
}
