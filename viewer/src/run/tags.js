// Names at the objects. Of two that would overlap, the nearer one is shown.
import { overlaps } from '../declutter.js';
import { h } from '../dom.js';
import { projector } from '../projection.js';

const GAP = 4; // [CSS pixels]
const ABOVE = 14; // of an object's top

export class Tags {
  constructor() {
    this.element = h('div', { class: 'tags', 'aria-hidden': 'true' });
    this.sizes = new Map(); // by text, because measuring is slow
  }

  begin() { this.used = 0; }

  #element() {
    if (!this.element.children[this.used]) this.element.append(h('span', { class: 'tag' }));
    const element = this.element.children[this.used++];
    element.hidden = false;
    return element;
  }

  #sizeOf(text, element) {
    if (!this.sizes.has(text)) this.sizes.set(text, { width: element.offsetWidth, height: element.offsetHeight });
    return this.sizes.get(text);
  }

  place(tags, { left, width }, camera, height) {
    const project = projector(camera, width, height);
    const seen = tags.map(({ at, text }) => ({ text, p: project(...at) })).filter(({ p }) => p);
    seen.sort((a, b) => a.p.depth - b.p.depth);
    const taken = [];
    for (const { text, p } of seen) {
      const element = this.#element();
      if (element.textContent !== text) element.textContent = text;
      const size = this.#sizeOf(text, element);
      const [x, y] = [p.x, p.y - ABOVE];
      const box = { left: x - size.width / 2, right: x + size.width / 2, top: y - size.height / 2, bottom: y + size.height / 2 };
      const outside = box.left < 0 || box.right > width || box.top < 0 || box.bottom > height;
      if (outside || taken.some((other) => overlaps(box, other, GAP))) element.hidden = true;
      else taken.push(box);
      element.style.transform = `translate(${Math.round(left + box.left)}px, ${Math.round(box.top)}px)`;
    }
  }

  end() {
    for (let i = this.used; i < this.element.children.length; ++i) this.element.children[i].hidden = true;
  }

  /** What is shown now: {text, x, y} of the centres. */
  get shown() {
    const origin = this.element.getBoundingClientRect();
    return [...this.element.children].filter(({ hidden }) => !hidden).map((element) => {
      const box = element.getBoundingClientRect();
      return { text: element.textContent, x: box.left - origin.left, y: box.top - origin.top, width: box.width, height: box.height };
    });
  }
}
