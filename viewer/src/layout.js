// The part of the canvas that no panel covers, and rectangles that labels avoid.
import { projector } from './projection.js';

const NARROW = '(max-width: 820px) and (orientation: portrait)'; // as in style.css

const localBox = (element, origin) => {
  const box = element.getBoundingClientRect();
  return { left: box.left - origin.left, right: box.right - origin.left, top: box.top - origin.top, bottom: box.bottom - origin.top };
};

export function createLayout({ canvas, viewpoint, stage }) {
  let parts = null;
  let size = { width: 1, height: 1 };

  function free() {
    const origin = canvas.getBoundingClientRect();
    const panel = localBox(parts.panel, origin);
    const narrow = matchMedia(NARROW).matches;
    return {
      left: 8, top: 8,
      right: narrow ? size.width - 8 : panel.left - 8,
      bottom: narrow ? panel.top - 8 : size.height - 8,
    };
  }

  function obstacles() {
    const origin = canvas.getBoundingClientRect();
    return [...parts.toolbar.children, parts.views].map((element) => localBox(element, origin));
  }

  // The part in which the scene is framed: below the toolbar and, if there is room, above the views.
  function framed() {
    const area = free();
    const origin = canvas.getBoundingClientRect();
    const top = localBox(parts.toolbar, origin).bottom + 4;
    const bottom = Math.max(localBox(parts.views, origin).top - 4, top + 60);
    return { left: area.left, top, width: Math.max(60, area.right - area.left), height: bottom - top };
  }

  function update() {
    const box = canvas.parentElement.getBoundingClientRect();
    size = { width: Math.max(1, box.width), height: Math.max(1, box.height) };
    const sheet = innerHeight - parts.panel.getBoundingClientRect().top;
    document.body.style.setProperty('--covered', `${Math.round(sheet)}px`);
    stage.resize(size.width, size.height);
    viewpoint.setViewport(size.width, size.height, framed());
    stage.invalidate();
  }

  return {
    free, obstacles, update,
    project: () => projector(viewpoint.camera, size.width, size.height),
    attach(elements) {
      parts = elements;
      new ResizeObserver(update).observe(canvas.parentElement);
      update();
    },
  };
}
