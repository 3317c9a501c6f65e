// The hash of the address sets the view, so that a picture can be reproduced:
// #view=front&select=3&mode=objects&completed=all&planes=0&only=1,4
import { isView } from './camera.js';
import { graspOf } from './grasps.js';

const MODES = ['scan', 'blend', 'objects'];

export function applyHash(hash, { scene, store, objects, viewpoint }) {
  const wanted = new URLSearchParams(hash.replace(/^#/, ''));
  const byId = (text) => objects.find((object) => String(object.id) === text.trim())?.index;
  const byIds = (text) => new Set(text.split(',').map(byId).filter((index) => index !== undefined));
  const patch = {};
  for (const key of ['planes', 'axes', 'labels', 'rest', 'mesh', 'path', 'grasps', 'views']) {
    if (wanted.has(key)) patch[key] = wanted.get(key) !== '0';
  }
  if (MODES.includes(wanted.get('mode'))) patch.mode = wanted.get('mode');
  if (wanted.has('select')) patch.selected = byId(wanted.get('select')) ?? null;
  const grasp = scene.grasps && graspOf(scene.grasps, wanted.get('grasp'));
  if (grasp) Object.assign(patch, { selected: grasp.object, grasp: wanted.get('grasp') });
  if (wanted.has('only')) patch.visible = byIds(wanted.get('only'));
  if (wanted.has('completed')) {
    const all = wanted.get('completed') === 'all';
    patch.completed = all ? new Set(objects.map((object) => object.index)) : byIds(wanted.get('completed'));
  }
  store.set(patch);
  if (isView(wanted.get('view'))) viewpoint.go(wanted.get('view'), false);
}
