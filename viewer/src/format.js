// Numbers as the page prints them.

const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);

export const count = (value) => value.toLocaleString('en-US');
export const plural = (n, word) => `${count(n)} ${word}${n === 1 ? '' : 's'}`;
export const fixed = (value, digits) => (isNumber(value) ? value.toFixed(digits) : '–');
export const percent = (value) => (isNumber(value) ? `${Math.round(value * 100)} %` : '–');

export function seconds(value) {
  if (!isNumber(value)) return '–';
  if (value >= 1) return `${value.toFixed(2)} s`;
  return value >= 0.01 ? `${(value * 1000).toFixed(0)} ms` : `${(value * 1000).toFixed(1)} ms`;
}

export const centimetres = (value) => (value * 100).toFixed(1);

/** Turns the identifier of a stage, step or reason into words. */
export function words(name) {
  const text = String(name).replace(/_/g, ' ').trim();
  return text.charAt(0).toUpperCase() + text.slice(1);
}
