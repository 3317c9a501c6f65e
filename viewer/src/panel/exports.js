// Buttons that save the picture and the objects, and copy the address of the view.
import { h } from '../dom.js';
import { icon } from '../icons.js';

const SHOWN = 1500; // ms that a button says that it copied

/** A button that copies, and says whether it could. */
export function copyButton(text, title, copy) {
  const label = h('span', {}, text);
  const button = h('button', { class: 'chip', type: 'button', title, onclick: async () => {
    label.textContent = await copy() ? 'Copied' : 'Not allowed';
    setTimeout(() => { label.textContent = text; }, SHOWN);
  } }, icon('copy'), label);
  return button;
}

export function createExportButtons(scene, exports) {
  const save = (text, title, onclick, name) => h('button', { class: 'chip', type: 'button', title, onclick }, icon(name), h('span', {}, text));
  return h('div', { class: 'exports', role: 'group', 'aria-label': 'Save and share' },
    save('PNG', 'Save this view as a picture', exports.savePicture, 'picture'),
    scene.objects.length > 0 && save('GLB', 'Save all objects as one glTF file, in metres', exports.saveObjects, 'mesh'),
    copyButton('Link', 'Copy the address of this view', exports.copyAddress));
}
