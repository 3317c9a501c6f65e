// The measured distance beside its line, and what to do while there is none.
import { h } from '../dom.js';
import { measureText, middleOf } from '../measure.js';

const HINTS = ['Click two points.', 'Click the second point.'];

export function createMeasure(store) {
  const text = h('output', { class: 'distance', hidden: true });
  const hint = h('p', { class: 'hint', role: 'status', hidden: true });
  store.subscribe(({ measure, marks }) => {
    hint.hidden = !measure || marks.length === 2;
    hint.textContent = HINTS[marks.length] ?? '';
    text.hidden = marks.length < 2;
    if (marks.length === 2) text.textContent = measureText(marks);
  });
  return {
    element: h('div', { class: 'measured' }, text, hint),
    place({ marks }, project) {
      if (marks.length < 2) return;
      const p = project(...middleOf(marks));
      text.style.visibility = p ? 'visible' : 'hidden';
      if (p) text.style.transform = `translate(${p.x}px, ${p.y}px) translate(-50%, -130%)`;
    },
  };
}
