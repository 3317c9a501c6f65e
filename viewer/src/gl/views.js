// Views that the camera could take next, as viewing pyramids; the better, the stronger.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { group, quadrilateral, segments } from './lines.js';
import { pyramid } from './pyramid.js';
import { css, qualityColor } from '../palette.js';
import { gainShare } from '../views.js';

export const DEPTH = 0.07; // of a pyramid [m]

class Pyramid {
  constructor({ camera }, share, halfSize) {
    const color = css(qualityColor(share));
    this.line = new LineMaterial({ linewidth: 1 + 1.5 * share, transparent: true, depthWrite: false, color });
    this.sheet = new THREE.MeshBasicMaterial({ transparent: true, side: THREE.DoubleSide, depthWrite: false, color });
    const { frame, edges } = pyramid(camera, halfSize, DEPTH);
    this.object = group(segments(edges, this.line, 3), quadrilateral(frame, this.sheet, 2));
    this.share = share;
  }

  show(isStrong, isFaint) {
    this.line.opacity = isStrong ? 1 : (isFaint ? 0.25 : 0.3 + 0.7 * this.share);
    this.sheet.opacity = isStrong ? 0.75 : (isFaint ? 0.04 : 0.08 + 0.3 * this.share);
  }
}

export class Views {
  constructor(views) {
    this.pyramids = views.list.map((view, rank) => new Pyramid(view, gainShare(views, rank), views.half_size));
    this.object = group(...this.pyramids.map(({ object }) => object));
  }

  show({ views, view, hoveredView }) {
    this.object.visible = views;
    const marked = hoveredView ?? view;
    this.pyramids.forEach((pyramid, rank) => pyramid.show(rank === marked, marked !== null && rank !== marked));
  }
}
