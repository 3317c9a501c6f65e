// Pause, scrubbing through the kept updates, and how many points are drawn.
import { h, setPressed } from '../dom.js';

const BUDGETS = [5000, 20000, 100000, 1000000];
const label = (points) => (points >= 1000000 ? 'all points' : `${points / 1000}k points`);

export class LiveControls {
  onFollow = () => {};
  onSeek = () => {};
  onBudget = () => {};

  constructor() {
    this.follow = h('button', { class: 'follow', type: 'button', 'aria-pressed': 'true', title: 'Follow the newest update (space)', onclick: () => this.onFollow() }, 'Live');
    this.slider = h('input', { class: 'updates', type: 'range', min: 1, max: 1, value: 1, step: 1, disabled: true, 'aria-label': 'Update', oninput: () => this.onSeek(Number(this.slider.value)) });
    this.at = h('span', { class: 'at-update' });
    this.budget = h('select', { class: 'budget', 'aria-label': 'Largest number of points', onchange: () => this.onBudget(Number(this.budget.value)) },
      BUDGETS.map((points) => h('option', { value: points, selected: points === 20000 }, label(points))));
    this.element = h('div', { class: 'player' }, this.follow, this.slider, this.at, this.budget);
    document.addEventListener('keydown', (event) => this.#press(event));
  }

  #press(event) {
    if (event.target.matches?.('input, select, button') || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === ' ') this.onFollow();
    else if (event.key === 'ArrowLeft') this.onSeek(Number(this.slider.value) - 1);
    else if (event.key === 'ArrowRight') this.onSeek(Number(this.slider.value) + 1);
    else return;
    event.preventDefault();
  }

  show({ oldest, newest, shown, following }) {
    Object.assign(this.slider, { min: oldest, max: newest, disabled: newest <= oldest });
    this.slider.value = shown;
    this.at.textContent = `${shown} of ${newest}`;
    this.follow.textContent = following ? 'Live' : 'Paused';
    setPressed(this.follow, following);
  }
}
