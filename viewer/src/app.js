// Connects the state, the drawn scene and the controls.
import { keepAddress } from './address.js';
import { Viewpoint } from './camera.js';
import { h } from './dom.js';
import { applyHash } from './hash.js';
import { listenToKeys } from './keyboard.js';
import { Labels } from './labels.js';
import { createHook } from './hook.js';
import { framePoints, gripperPoints, pathPoints, reach, viewPoints } from './framing.js';
import { createExports } from './exports.js';
import { createLayout } from './layout.js';
import { createPanel } from './panel/panel.js';
import { createMeasure } from './panel/measure.js';
import { listenToPointer } from './pointer.js';
import { createDrawing } from './drawing.js';
import { footprint } from './footprint.js';
import { createActions, createStore, initialState } from './store.js';
import { createToolbar, createViews } from './toolbar.js';
import { outlinePoints } from './gl/symmetries.js';
import { Stage } from './gl/stage.js';

function drawOnChange(app) {
  const { store, stage, drawing, labels } = app;
  store.subscribe((state, changed) => {
    drawing.update(state, changed);
    labels.update(state);
    stage.invalidate();
  });
  const scheme = matchMedia('(prefers-color-scheme: dark)');
  const applyScheme = () => { drawing.setScheme(scheme.matches ? 'dark' : 'light'); stage.invalidate(); };
  scheme.addEventListener('change', applyScheme);
  applyScheme();
}

export function createApp(scene) {
  const store = createStore(initialState(scene));
  const actions = createActions(store, scene.objects);
  const outlines = scene.objects.map((object) => outlinePoints(scene.cloud, object));
  const canvas = h('canvas', { tabindex: '0', role: 'img', 'aria-label': 'The scene in three dimensions' });
  const framed = framePoints(scene, outlines).concat(gripperPoints(scene), viewPoints(scene));
  const viewpoint = new Viewpoint(canvas, framed, reach(scene));
  const stage = new Stage(canvas, viewpoint.camera);
  const drawing = createDrawing(scene, outlines, stage);
  const labels = new Labels(scene.objects, outlines, actions);
  const app = { scene, store, actions, objects: scene.objects, canvas, viewpoint, stage, drawing, labels };
  app.layout = createLayout(app);
  const panel = createPanel({
    scene, store, actions, cell: drawing.cell, onResize: app.layout.update,
    extentOf: (index) => footprint(outlines[index]),
    exports: createExports(app),
  });
  const measure = createMeasure(store);
  const toolbar = createToolbar(scene, store, actions);
  const views = createViews(viewpoint);
  document.body.append(h('main', { class: 'stage' }, canvas, labels.element, measure.element), toolbar, views, panel);
  app.layout.attach({ panel, toolbar, views });
  viewpoint.onChange = () => stage.invalidate();
  viewpoint.controls.addEventListener('change', () => stage.invalidate());
  stage.beforeDraw.push(() => viewpoint.step());
  stage.afterDraw.push(() => labels.place(store.get(), app.layout.project(), app.layout.free(), app.layout.obstacles()));
  stage.afterDraw.push(() => measure.place(store.get(), app.layout.project()));
  listenToPointer(app);
  listenToKeys(app);
  drawOnChange(app);
  let isBegun = false;
  store.subscribe(({ path }, changed) => {
    if (changed.has('path')) viewpoint.show(path ? framed.concat(pathPoints(scene)) : framed, path && isBegun);
  });
  isBegun = true;
  const readHash = () => applyHash(location.hash, app);
  addEventListener('hashchange', readHash);
  readHash();
  app.address = keepAddress(app);
  createHook(app);
  return app;
}
