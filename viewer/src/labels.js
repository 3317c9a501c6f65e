// Number labels of the objects, with leader lines.
import { h, svg } from './dom.js';
import { placeLabels } from './declutter.js';
import { css, inkOn, objectColor } from './palette.js';
import { quantile } from './vector.js';

const SIZE = 24;

// The top of an object, above its centre.
function anchorOf(outline) {
  const along = (axis) => outline.map((p) => p[axis]);
  return [quantile(along(0), 0.5), quantile(along(1), 0.97), quantile(along(2), 0.5)];
}

function createLabel(object, outline, actions) {
  const color = objectColor(object.index);
  const element = h('button', {
    class: 'label', type: 'button', tabindex: '-1', 'aria-label': object.name,
    style: { '--color': css(color), '--on-color': inkOn(color) },
    onclick: () => actions.toggleSelect(object.index),
    onpointerenter: (event) => actions.hoverWith(event, object.index),
    onpointerleave: () => actions.hover(null),
  }, String(object.id));
  const line = svg('line', { class: 'leader', stroke: css(color) });
  const dot = svg('circle', { class: 'anchor', r: 2.5, fill: css(color) });
  return { object, element, line, dot, anchor: anchorOf(outline) };
}

export class Labels {
  constructor(objects, outlines, actions) {
    this.labels = objects.map((object, i) => createLabel(object, outlines[i], actions));
    const marks = this.labels.flatMap(({ line, dot }) => [line, dot]);
    this.element = h('div', { class: 'labels' },
      svg('svg', { class: 'leaders', 'aria-hidden': 'true' }, ...marks),
      this.labels.map(({ element }) => element));
  }

  update(state) {
    for (const { object, element } of this.labels) {
      element.classList.toggle('selected', state.selected === object.index);
      element.classList.toggle('hovered', state.hovered === object.index);
    }
  }

  /** Moves every label to its object's position on the canvas. */
  place(state, project, area, obstacles) {
    const shown = [];
    for (const label of this.labels) {
      const p = state.labels && state.visible.has(label.object.index) ? project(...label.anchor) : null;
      if (p) shown.push({ label, x: p.x, y: p.y, width: label.element.offsetWidth || SIZE, height: SIZE });
      else this.#hide(label);
    }
    // The selected object is placed first, then those higher on the screen, which have less room.
    const rank = ({ label }) => (label.object.index === state.selected ? 0 : 1);
    shown.sort((a, b) => rank(a) - rank(b) || a.y - b.y);
    const places = placeLabels(shown, area, obstacles);
    shown.forEach((entry, i) => (places[i] ? this.#show(entry, places[i]) : this.#hide(entry.label)));
  }

  /** The labels that are seen: their anchors, places and colours, in CSS pixels. */
  shown() {
    return this.labels.filter(({ element }) => element.style.visibility === 'visible').map(({ element, line, object }) => {
      const at = (name) => Number(line.getAttribute(name));
      const color = objectColor(object.index);
      return { x: at('x1'), y: at('y1'), placeX: at('x2'), placeY: at('y2'), text: String(object.id), color: css(color), ink: inkOn(color) };
    });
  }

  #hide({ element, line, dot }) {
    element.style.visibility = line.style.visibility = dot.style.visibility = 'hidden';
  }

  #show({ label: { element, line, dot }, x, y }, place) {
    element.style.visibility = line.style.visibility = dot.style.visibility = 'visible';
    element.style.transform = `translate(${place.x}px, ${place.y}px) translate(-50%, -50%)`;
    for (const [name, value] of Object.entries({ x1: x, y1: y, x2: place.x, y2: place.y })) {
      line.setAttribute(name, value);
    }
    dot.setAttribute('cx', x);
    dot.setAttribute('cy', y);
  }
}
