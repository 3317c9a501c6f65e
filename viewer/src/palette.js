// One colour per object. The first twelve are chosen to stay apart for the common colour
// deficiencies (after Okabe and Ito, and Tol); then hues by the golden angle.

const CURATED = [
  [0, 119, 187], [238, 119, 51], [0, 158, 115], [204, 51, 119], [225, 170, 30], [86, 180, 233],
  [140, 86, 200], [200, 60, 40], [120, 160, 40], [0, 150, 160], [240, 130, 170], [150, 105, 70],
];

function hslToRgb(hue, saturation, lightness) {
  const a = saturation * Math.min(lightness, 1 - lightness);
  const channel = (n) => {
    const k = (n + hue / 30) % 12;
    return Math.round(255 * (lightness - a * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}

export function objectColor(index) {
  if (index < CURATED.length) return CURATED[index];
  const extra = index - CURATED.length;
  return hslToRgb((40 + extra * 137.508) % 360, 0.55, [0.5, 0.66, 0.38][extra % 3]);
}

export const mix = (a, b, t) => a.map((value, i) => Math.round(value + (b[i] - value) * t));
export const lighter = (color) => mix(color, [255, 255, 255], 0.5);
export const css = (color) => `rgb(${color.join(', ')})`;

// From poor to good, apart for the common colour deficiencies in lightness too.
const QUALITY = [[178, 48, 40], [238, 119, 51], [235, 190, 60], [90, 180, 120], [0, 128, 110]];

/** The colour of a quality in [0, 1]. */
export function qualityColor(quality) {
  const position = Math.min(1, Math.max(0, Number(quality) || 0)) * (QUALITY.length - 1);
  const lower = Math.min(Math.floor(position), QUALITY.length - 2);
  return mix(QUALITY[lower], QUALITY[lower + 1], position - lower);
}

/** Black or white, whichever reads better on `color`. */
export function inkOn(color) {
  const [r, g, b] = color.map((value) => (value / 255) ** 2.2);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.36 ? '#14161a' : '#ffffff';
}
