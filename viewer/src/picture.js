// The view as a PNG: the scene with its labels, as large as the screen has pixels.

const PAPER = { light: '#eceff4', dark: '#1c2027' };
const RADIUS = 12; // of a label [CSS pixels]
const FONT = '650 12.5px system-ui, sans-serif';

function drawLabel(context, { x, y, placeX, placeY, text, color, ink }) {
  context.strokeStyle = context.fillStyle = color;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(placeX, placeY);
  context.stroke();
  context.beginPath();
  context.arc(placeX, placeY, RADIUS, 0, 2 * Math.PI);
  context.fill();
  context.fillStyle = ink;
  context.fillText(text, placeX, placeY + 0.5);
}

/** The picture as a canvas. `scheme` is light or dark. */
export function pictureOf({ canvas, stage, labels }, scheme) {
  stage.drawNow(2);
  const picture = document.createElement('canvas');
  Object.assign(picture, { width: canvas.width, height: canvas.height });
  const context = picture.getContext('2d');
  context.fillStyle = PAPER[scheme];
  context.fillRect(0, 0, picture.width, picture.height);
  context.drawImage(canvas, 0, 0);
  const scale = canvas.width / canvas.clientWidth;
  context.scale(scale, scale);
  Object.assign(context, { font: FONT, textAlign: 'center', textBaseline: 'middle' });
  for (const label of labels.shown()) drawLabel(context, label);
  return picture;
}

export const pngOf = (picture) => new Promise((resolve) => { picture.toBlob(resolve, 'image/png'); });
