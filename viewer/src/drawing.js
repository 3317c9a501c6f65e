// Draws the layers according to the state: cloud, completed objects, surface, symmetries, camera
// path, grippers, views, table.
import { coverage } from './coverage.js';
import { Highlight } from './gl/highlight.js';
import { MovingLines } from './gl/moving_lines.js';
import { Grippers } from './gl/grippers.js';
import { Shape } from './gl/shape.js';
import { Splats, sampleSpacing } from './gl/splats.js';
import { Surface } from './gl/surface.js';
import { Symmetries } from './gl/symmetries.js';
import { createTable } from './gl/table.js';
import { Trajectory } from './gl/trajectory.js';
import { Views } from './gl/views.js';
import { drawnGrasps, graspOf } from './grasps.js';
import { pyramid } from './gl/pyramid.js';
import { paintClosed, paintCloud, paintCompleted, paintSurface } from './painting.js';
import { objectColor } from './palette.js';
import { add, subtract } from './vector.js';

const RADIUS_OF_SPACING = 1.15;
const CAMERA = { color: '#d61e82', width: 3, depth: 0.09, slope: [0.55, 0.42] };
const MEASURE = { color: '#d61e82', width: 2.5 };
const GRASP_KEYS = ['grasps', 'visible', 'selected', 'grasp', 'hoveredGrasp'];
const TABLE_THICKNESS = 0.004; // of its surface, with noise [m]
const SCHEMES = {
  light: { paper: [232, 235, 240], outline: [24, 28, 36], ink: [60, 70, 90], path: [52, 60, 76], grid: 0.22, shadow: 0.34 },
  dark: { paper: [38, 42, 49], outline: [255, 255, 255], ink: [150, 165, 190], path: [205, 214, 230], grid: 0.2, shadow: 0.75 },
};

// The closed surface of every object or, where there is none, the added points.
function createCompleted(scene, radius, stage) {
  return scene.objects.map((object) => {
    const layer = object.closed ? new Surface(object.closed) : new Splats(object.completed, radius);
    if (object.closed) paintClosed(layer, object);
    else paintCompleted(layer, object);
    stage.cloud.add(layer.object);
    return layer;
  });
}

function createSymmetries(scene, outlines, stage) {
  return scene.objects.map((object, i) => {
    const symmetries = new Symmetries(object, outlines[i], objectColor(object.index));
    stage.overlay.add(symmetries.planes, symmetries.axes);
    return symmetries;
  });
}

// The fitted surface of every object, drawn where it is selected.
function createShapes(scene, stage) {
  return scene.objects.map((object) => {
    const shape = new Shape(object, objectColor(object.index));
    stage.overlay.add(shape.object);
    return shape;
  });
}

// The mesh, and which points it shows.
function createSurface(scene, spacing, stage) {
  if (!scene.surface) return null;
  const mesh = new Surface(scene.surface);
  stage.cloud.add(mesh.object);
  const lowest = scene.table === null ? -Infinity : TABLE_THICKNESS;
  return { mesh, ...coverage(scene.surface, mesh.normals, scene.cloud, spacing, lowest) };
}

function createTrajectory(scene, stage) {
  if (!scene.trajectory) return null;
  const trajectory = new Trajectory(scene.trajectory);
  stage.overlay.add(trajectory.object);
  return trajectory;
}

function createViews(scene, stage) {
  if (!scene.views) return null;
  const views = new Views(scene.views);
  stage.overlay.add(views.object);
  return views;
}

function createGrippers(scene, stage) {
  if (!scene.grasps) return null;
  const grippers = new Grippers(scene.grasps);
  stage.overlay.add(grippers.object);
  return grippers;
}

// The measured line with a cross at each of its ends.
function markLines(marks, size) {
  const axes = [[size, 0, 0], [0, size, 0], [0, 0, size]];
  const crosses = marks.flatMap((mark) => axes.map((axis) => [subtract(mark, axis), add(mark, axis)]));
  return marks.length === 2 ? [marks, ...crosses] : crosses;
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
    this.shapes = createShapes(scene, stage);
    this.surface = createSurface(scene, spacing, stage);
    this.trajectory = createTrajectory(scene, stage);
    this.grippers = createGrippers(scene, stage);
    this.views = createViews(scene, stage);
    this.highlight = new Highlight(3 * this.radius);
    this.played = new MovingLines(CAMERA.color, CAMERA.width);
    this.measured = new MovingLines(MEASURE.color, MEASURE.width);
    stage.overlay.add(this.highlight.object, this.played.object, this.measured.object);
    this.table = createTable(scene.cloud.positions);
    this.cell = this.table.cell;
    stage.ground.add(this.table.mesh);
    this.scheme = 'light';
  }

  setScheme(scheme) {
    this.scheme = scheme;
    const { ink, grid, shadow, outline, paper, path } = SCHEMES[scheme];
    this.table.uniforms.ink.value.setRGB(...ink.map((value) => value / 255));
    this.table.uniforms.gridOpacity.value = grid;
    this.table.uniforms.shadowOpacity.value = shadow;
    this.stage.setOutline(outline);
    this.trajectory?.setColor(path);
    for (const symmetries of this.symmetries) symmetries.setScheme(scheme, paper);
    for (const shape of this.shapes) shape.setScheme(scheme);
    if (this.state) this.update(this.state, new Set(['mode', 'selected']));
  }

  update(state, changed) {
    this.state = state;
    if (['mode', 'visible', 'rest', 'mesh', 'completed'].some((key) => changed.has(key))) this.#paint(state);
    if (this.surface) this.surface.mesh.object.visible = state.mesh;
    if (this.trajectory) this.trajectory.object.visible = state.path;
    this.views?.show(state);
    if (this.grippers && GRASP_KEYS.some((key) => changed.has(key))) this.#showGrasps(state);
    this.#showMarks(state, changed);
    const { paper } = SCHEMES[this.scheme];
    const selected = state.visible.has(state.selected) ? state.selected : null;
    for (const layer of [this.cloud, ...this.completed, this.surface?.mesh]) {
      layer?.emphasise(selected, state.hovered, paper);
    }
    this.stage.setOutlined(selected !== null || state.hovered !== null);
    this.scene.objects.forEach((object) => this.#updateObject(object, state, selected));
  }

  #showMarks({ rejection, marks, moment }, changed) {
    const { cloud, rejected, sweep } = this.scene;
    if (changed.has('rejection')) {
      const points = rejection === null ? [] : [...rejected[rejection].points];
      this.highlight.show(points.flatMap((i) => [...cloud.positions.subarray(3 * i, 3 * i + 3)]));
    }
    if (changed.has('marks')) this.measured.show(markLines(marks, 2 * this.radius));
    if (changed.has('moment')) this.played.show(moment === null ? [] : pyramid(sweep[moment].camera, CAMERA.slope, CAMERA.depth).edges);
  }

  #showGrasps(state) {
    this.drawnGrasps = drawnGrasps(this.scene.grasps, state);
    this.grippers.show(this.drawnGrasps.map(([key, emphasis]) => [graspOf(this.scene.grasps, key), emphasis]));
  }

  #paint(state) {
    const { cloud, objects, surface } = this.scene;
    paintCloud(this.cloud, cloud, objects, state, this.scheme, this.#covered(state));
    if (!this.surface || !state.mesh) return;
    paintSurface(this.surface.mesh, surface, this.surface.nearest, cloud, objects, state, this.scheme);
  }

  // The points that the mesh or a closed surface shows.
  #covered(state) {
    const { cloud, objects } = this.scene;
    const covered = state.mesh && this.surface ? this.surface.covered.slice() : new Uint8Array(cloud.count);
    for (const { index, closed, points } of objects) {
      if (closed && state.completed.has(index)) points.forEach((i) => { covered[i] = 1; });
    }
    return covered;
  }

  #updateObject({ index }, state, selected) {
    const visible = state.visible.has(index);
    const strong = selected === index || state.hovered === index;
    const emphasis = strong ? 'strong' : selected === null ? 'normal' : 'faint';
    this.completed[index].object.visible = visible && state.completed.has(index);
    this.shapes[index].object.visible = visible && selected === index;
    this.symmetries[index].show(visible && state.planes, visible && state.axes, emphasis);
  }

  /** The layers between whose points distances are measured: the mesh too. */
  measuredLayers() {
    const mesh = this.surface?.mesh.object.visible ? [this.surface.mesh] : [];
    return [...this.layers(), ...mesh];
  }

  /** The layers that can be picked. */
  layers() {
    const completed = this.completed.filter((layer) => layer.object.visible);
    return [this.cloud, ...completed];
  }
}

export const createDrawing = (scene, outlines, stage) => new Drawing(scene, outlines, stage);
