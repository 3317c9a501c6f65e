// The scene's layers, kept in step with the state: cloud, completed points, symmetries, table.
import { Splats, sampleSpacing } from './gl/splats.js';
import { Symmetries } from './gl/symmetries.js';
import { createTable } from './gl/table.js';
import { paintCloud, paintCompleted } from './painting.js';
import { objectColor } from './palette.js';

const RADIUS_OF_SPACING = 1.15;
const SCHEMES = {
  light: { paper: [232, 235, 240], outline: [24, 28, 36], ink: [60, 70, 90], grid: 0.22, shadow: 0.34 },
  dark: { paper: [38, 42, 49], outline: [255, 255, 255], ink: [150, 165, 190], grid: 0.2, shadow: 0.75 },
};

function createCompleted(scene, radius, stage) {
  return scene.objects.map((object) => {
    const splats = new Splats(object.completed, radius);
    paintCompleted(splats, object);
    stage.cloud.add(splats.object);
    return splats;
  });
}

function createSymmetries(scene, outlines, stage) {
  return scene.objects.map((object, i) => {
    const symmetries = new Symmetries(object, outlines[i], objectColor(object.index));
    stage.overlay.add(symmetries.planes, symmetries.axes);
    return symmetries;
  });
}

export class Drawing {
  constructor(scene, outlines, stage) {
    this.scene = scene;
    this.stage = stage;
    this.outlines = outlines;
    const spacing = sampleSpacing(scene.cloud.positions);
    this.radius = RADIUS_OF_SPACING * spacing;
    this.cloud = new Splats(scene.cloud, this.radius);
    stage.cloud.add(this.cloud.object);
    this.completed = createCompleted(scene, this.radius, stage);
    this.symmetries = createSymmetries(scene, outlines, stage);
    this.table = createTable(scene.cloud.positions);
    this.cell = this.table.cell;
    stage.ground.add(this.table.mesh);
    this.scheme = 'light';
  }

  setScheme(scheme) {
    this.scheme = scheme;
    const { ink, grid, shadow, outline, paper } = SCHEMES[scheme];
    this.table.uniforms.ink.value.setRGB(...ink.map((value) => value / 255));
    this.table.uniforms.gridOpacity.value = grid;
    this.table.uniforms.shadowOpacity.value = shadow;
    this.stage.setOutline(outline);
    for (const symmetries of this.symmetries) symmetries.setScheme(scheme, paper);
    if (this.state) this.update(this.state, new Set(['mode', 'selected']));
  }

  update(state, changed) {
    this.state = state;
    if (['mode', 'visible', 'rest'].some((key) => changed.has(key))) {
      paintCloud(this.cloud, this.scene.cloud, this.scene.objects, state, this.scheme);
    }
    const { paper } = SCHEMES[this.scheme];
    const selected = state.visible.has(state.selected) ? state.selected : null;
    for (const splats of [this.cloud, ...this.completed]) splats.emphasise(selected, state.hovered, paper);
    this.stage.setOutlined(selected !== null || state.hovered !== null);
    this.scene.objects.forEach((object) => this.#updateObject(object, state, selected));
  }

  #updateObject({ index }, state, selected) {
    const visible = state.visible.has(index);
    const strong = selected === index || state.hovered === index;
    const emphasis = strong ? 'strong' : selected === null ? 'normal' : 'faint';
    this.completed[index].object.visible = visible && state.completed.has(index);
    this.symmetries[index].show(visible && state.planes, visible && state.axes, emphasis);
  }

  /** What the pointer can hit. */
  layers() {
    const completed = this.completed.filter((splats) => splats.object.visible);
    return [this.cloud, ...completed];
  }
}

export const createDrawing = (scene, outlines, stage) => new Drawing(scene, outlines, stage);
