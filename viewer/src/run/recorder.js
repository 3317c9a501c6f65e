// Saves a video of the views with captions, time and event, from the current moment until it is stopped or the run ends.
import { h } from '../dom.js';
import { download, fileName } from '../download.js';
import { clock } from './words.js';

const FRAMES = 30; // per second
const BITS = 8e6; // per second
const FOOT = 34; // height of the line with time and event [CSS pixels]
const TYPES = [['video/webm;codecs=vp9', 'webm'], ['video/webm;codecs=vp8', 'webm'], ['video/webm', 'webm'], ['video/mp4', 'mp4']];
const CAPTIONS = { true: 'True scene', believed: 'What the robot believes' };
const COLORS = { light: { paper: '#eef1f5', ink: '#171b22', rule: '#d3d9e2' }, dark: { paper: '#1c2027', ink: '#eceff4', rule: '#3a414d' } };

const typeOf = () => (window.MediaRecorder && TYPES.find(([type]) => MediaRecorder.isTypeSupported(type))) || null;

export class Recorder {
  onChange = () => {};

  constructor(view, player, recording) {
    Object.assign(this, { view, player, recording });
    this.type = typeOf();
    this.supported = this.type !== null && Boolean(HTMLCanvasElement.prototype.captureStream);
    this.media = null;
    this.toggle = () => (this.media ? this.stop() : this.start());
    view.afterDraw.push(() => { if (this.media) this.#compose(); });
    player.store.subscribe(({ playing }) => { if (this.media && !playing) this.stop(); });
  }

  start() {
    if (!this.supported) return;
    this.scale = Math.min(devicePixelRatio || 1, 2);
    const even = (size) => 2 * Math.round((size * this.scale) / 2); // as encoders want it
    this.frame = h('canvas', { width: even(this.view.width), height: even(this.view.height + FOOT) });
    this.media = new MediaRecorder(this.frame.captureStream(FRAMES), { mimeType: this.type[0], videoBitsPerSecond: BITS });
    const chunks = [];
    this.media.ondataavailable = ({ data }) => chunks.push(data);
    this.media.onstop = () => download(new Blob(chunks, { type: this.type[0] }), `${fileName(this.recording.title, 'run')}.${this.type[1]}`);
    this.view.draw();
    this.media.start();
    this.player.actions.play();
    this.onChange(true);
  }

  stop() {
    const { media } = this;
    if (!media) return;
    this.media = null; // before pausing, which stops too
    media.stop();
    this.player.actions.pause();
    this.onChange(false);
  }

  #compose() {
    const context = this.frame.getContext('2d');
    const colors = COLORS[this.view.world.bodies.scheme];
    const { width, height } = this.frame;
    context.fillStyle = colors.paper;
    context.fillRect(0, 0, width, height);
    context.setTransform(this.scale, 0, 0, this.scale, 0, 0);
    context.drawImage(this.view.canvas, 0, 0, this.view.width, this.view.height);
    this.#write(context, colors);
    context.setTransform(1, 0, 0, 1, 0, 0);
  }

  #write(context, colors) {
    const { time } = this.player.store.get();
    const event = this.recording.events[this.player.currentEvent(time)];
    context.fillStyle = colors.ink;
    context.font = '600 14px system-ui, sans-serif';
    for (const { side, left } of this.view.parts) context.fillText(CAPTIONS[side], left + 14, 26);
    for (const { text, x, y, width } of this.view.tags.shown) {
      context.font = '600 11px system-ui, sans-serif';
      context.fillText(text, x + 6, y + 13, width);
    }
    context.font = '500 13px system-ui, sans-serif';
    context.fillText(`${clock(time)}   ${event?.text ?? ''}`, 14, this.view.height + 21);
    context.fillStyle = colors.rule;
    for (const { left } of this.view.parts.slice(1)) context.fillRect(left - 0.5, 0, 1, this.view.height);
  }
}
