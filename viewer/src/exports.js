// What the buttons of the page save and copy.
import { download, fileName } from './download.js';
import { glbOf } from './glb.js';
import { pictureOf, pngOf } from './picture.js';

/** The pose of an object as JSON in the terms of objects.json: the frame fixed to it, in the frame of the result. */
export function poseText({ id, pose }) {
  return JSON.stringify({
    id, T_world_object: { position_m: pose.position, orientation_xyzw: pose.orientation }, size_m: pose.size,
  });
}

// A page that is a file may have no clipboard of its own.
async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = document.createElement('textarea');
    area.value = text;
    document.body.append(area);
    area.select();
    const isCopied = document.execCommand('copy');
    area.remove();
    return isCopied;
  }
}

export function createExports(app) {
  const name = fileName(app.scene.title, 'scene');
  const scheme = () => (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
  return {
    async savePicture() { download(await pngOf(pictureOf(app, scheme())), `${name}.png`); },
    saveObjects() { download(new Blob([glbOf(app.scene)], { type: 'model/gltf-binary' }), `${name}.glb`); },
    copyAddress() {
      app.address.write();
      return copyText(location.href);
    },
    copyPose: (object) => copyText(poseText(object)),
  };
}
