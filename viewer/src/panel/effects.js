// What decided a score: the features for and against.
import { h } from '../dom.js';
import { featureText, sides, valueText } from '../effects.js';

const row = (effect, most) => h('tr', { class: effect.effect > 0 ? 'raising' : 'lowering' },
  h('th', { scope: 'row' }, featureText(effect.feature), h('small', {}, valueText(effect))),
  h('td', { class: 'bar' }, h('span', { style: { width: `${(100 * Math.abs(effect.effect)) / most}%` } })),
  h('td', { class: 'number' }, `${effect.effect > 0 ? '+' : '−'}${Math.abs(effect.effect).toFixed(1)}`));

/** Null where nothing is known. */
export function createEffects(effects) {
  if (effects.length === 0) return null;
  const { raising, lowering } = sides(effects);
  const most = Math.max(...effects.map(({ effect }) => Math.abs(effect)), 1e-9);
  const part = (title, list) => list.length > 0 && [
    h('tr', { class: 'side' }, h('th', { colspan: '3', scope: 'colgroup' }, title)), ...list.map((each) => row(each, most)),
  ];
  return h('section', { class: 'effects', 'aria-label': 'What decided the score' },
    h('h3', { title: 'How far the feature moves the log-odds of the score, compared with its usual value: the median over all hypotheses of the scene' },
      'What decided the score'),
    h('table', { class: 'bars' }, h('tbody', {}, part('For an object', raising), part('Against', lowering))));
}
