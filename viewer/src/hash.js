// The hash of the address sets the view, so that a picture can be reproduced:
// #view=front&select=3&mode=objects&completed=all&planes=0&only=1,4 or, in place of view, camera=x,y,z,x,y,z: the position of the
// camera and the point that it looks at, in the frame of the result.
import { isView } from './camera.js';
import { graspOf } from './grasps.js';

const MODES = ['scan', 'blend', 'objects'];
const VECTORS = 6; // numbers of camera=

function applyCamera(text, { scene, viewpoint }) {
  const numbers = text.split(',').map(Number);
  if (numbers.length !== VECTORS || !numbers.every(Number.isFinite)) return;
  viewpoint.look(scene.frame.point(numbers.slice(0, 3)), scene.frame.point(numbers.slice(3)));
}

export function applyHash(hash, app) {
  const { scene, store, objects, viewpoint } = app;
  const wanted = new URLSearchParams(hash.replace(/^#/, ''));
  const byId = (text) => objects.find((object) => String(object.id) === text.trim())?.index;
  const byIds = (text) => new Set(text.split(',').map(byId).filter((index) => index !== undefined));
  const patch = {};
  for (const key of ['planes', 'axes', 'labels', 'rest', 'mesh', 'path', 'grasps', 'views']) {
    if (wanted.has(key)) patch[key] = wanted.get(key) !== '0';
  }
  if (wanted.get('mode') === 'truth' ? scene.truth : MODES.includes(wanted.get('mode'))) patch.mode = wanted.get('mode');
  if (wanted.has('select')) patch.selected = byId(wanted.get('select')) ?? null;
  const grasp = scene.grasps && graspOf(scene.grasps, wanted.get('grasp'));
  if (grasp) Object.assign(patch, { selected: grasp.object, grasp: wanted.get('grasp') });
  if (wanted.has('only')) patch.visible = byIds(wanted.get('only'));
  if (wanted.has('completed')) {
    const all = wanted.get('completed') === 'all';
    patch.completed = all ? new Set(objects.map((object) => object.index)) : byIds(wanted.get('completed'));
  }
  const rejection = wanted.get('rejected');
  if (rejection !== null && Number(rejection) in scene.rejected) patch.rejection = Number(rejection);
  store.set(patch);
  if (isView(wanted.get('view'))) viewpoint.go(wanted.get('view'), false);
  if (wanted.has('camera')) applyCamera(wanted.get('camera'), app);
}
