// Hovering and clicking the scene.
import { REST } from './ownership.js';
import { pick } from './picking.js';
import { viewProjection } from './projection.js';

const CLICK_MOVE = 5; // largest movement of a click [pixels]
const REACH = 5; // picking distance around small discs [pixels]

function pickAt(app, layers, x, y) {
  const { clientWidth: width, clientHeight: height } = app.canvas;
  const at = [(2 * x) / width - 1, 1 - (2 * y) / height];
  const reach = [(2 * REACH) / width, (2 * REACH) / height];
  return pick(layers, viewProjection(app.viewpoint.camera), at, reach);
}

function ownerAt(app, x, y) {
  const owner = pickAt(app, app.drawing.layers(), x, y)?.owner ?? REST;
  return owner === REST ? null : owner;
}

// A click selects an object; while measuring it marks a point.
function click(app, x, y) {
  if (!app.store.get().measure) return app.actions.select(ownerAt(app, x, y));
  const picked = pickAt(app, app.drawing.measuredLayers(), x, y);
  if (picked) app.actions.mark(picked.position);
}

function local(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

export function listenToPointer(app) {
  const { canvas, actions, viewpoint } = app;
  let down = null;
  let queued = null;
  canvas.addEventListener('pointerdown', (event) => {
    down = event.isPrimary && event.button === 0 ? local(canvas, event) : null;
  });
  canvas.addEventListener('pointerup', (event) => {
    const up = local(canvas, event);
    if (down && Math.hypot(up[0] - down[0], up[1] - down[1]) <= CLICK_MOVE) click(app, ...up);
    down = null;
  });
  canvas.addEventListener('pointermove', (event) => {
    if (event.pointerType === 'touch' || event.buttons) return;
    if (!queued) requestAnimationFrame(() => { if (queued) setHover(queued); queued = null; });
    queued = local(canvas, event);
  });
  canvas.addEventListener('pointerleave', () => { queued = null; actions.hover(null); });
  canvas.addEventListener('dblclick', (event) => {
    const owner = ownerAt(app, ...local(canvas, event));
    if (owner !== null) viewpoint.focus(app.drawing.outlines[owner]);
  });
  function setHover(position) {
    const owner = ownerAt(app, ...position);
    canvas.style.cursor = app.store.get().measure ? 'crosshair' : owner === null ? '' : 'pointer';
    actions.hover(owner);
  }
}
