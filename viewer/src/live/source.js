// The updates of the server that the page comes from. The browser reconnects by itself and says which update it got last.
import { decodeUpdate } from './decode.js';

export class LiveSource {
  onReport = () => {}; // ({run, report, oldest}) of each new update
  onState = () => {}; // 'waiting', 'live', 'lost', 'refused' or 'finished'

  constructor(location) {
    this.base = new URL('.', location);
    this.token = new URL(location).searchParams.get('token');
  }

  address(path, values = {}) {
    const url = new URL(path, this.base);
    for (const [name, value] of Object.entries(values)) url.searchParams.set(name, value);
    if (this.token) url.searchParams.set('token', this.token);
    return url;
  }

  listen() {
    this.events = new EventSource(this.address('events'));
    this.events.onopen = () => this.onState('live');
    this.events.onerror = () => this.onState(this.events.readyState === EventSource.CLOSED ? 'refused' : 'lost');
    this.events.onmessage = ({ data }) => this.onReport(JSON.parse(data));
    this.events.addEventListener('finished', () => {
      this.events.close();
      this.onState('finished');
    });
  }

  /** The update of a number with at most `points` points; null if the server no longer keeps it. */
  async fetch(number, points) {
    const reply = await fetch(this.address(`updates/${number}`, { points }), { cache: 'no-store' });
    if (reply.status === 404) return null;
    if (!reply.ok) throw new Error(`the server answered ${reply.status}`);
    return decodeUpdate(await reply.arrayBuffer());
  }
}
