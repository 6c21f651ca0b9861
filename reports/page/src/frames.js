// Pictures that a result holds step by step: one at a time, with a slider.

import { inflated } from './blocks.js';
import { el } from './dom.js';

const frame_ms = 400;

class Frames {
  constructor(set, lines) {
    this.lines = lines;
    this.set = set;
    this.timer = null;
    this.picture = el('img', { class: 'frame', alt: '' });
    this.label = el('output', {});
    this.slider = el('input', { type: 'range', min: 0, max: set.frames.length - 1, step: 1, value: 0,
      'aria-label': `Frame of ${set.title}`, oninput: () => this.show(Number(this.slider.value)) });
    this.playButton = el('button', { type: 'button', onclick: () => (this.timer ? this.stop() : this.play()) }, 'Play');
    const step = (words, by) => el('button', { type: 'button', onclick: () => {
      this.stop();
      this.show(Math.min(set.frames.length - 1, Math.max(0, this.index + by)));
    } }, words);
    this.element = el('section', { class: 'card frames', id: `frames-${set.id}` }, el('h3', {}, set.title),
      el('div', { class: 'player', role: 'group', 'aria-label': `Step through ${set.title}` },
        this.playButton, step('‹ Step', -1), step('Step ›', 1), el('span', { class: 'grow' }, this.slider), this.label),
      this.picture);
    this.show(0);
  }

  async show(index) {
    this.index = index;
    this.slider.value = index;
    const { name, type, line } = this.set.frames[index];
    this.label.textContent = `${index + 1} of ${this.set.frames.length}: ${name}`;
    this.slider.setAttribute('aria-valuetext', name);
    const { base64 } = await inflated(this.lines[line]);
    if (this.index !== index) return;
    this.picture.src = `data:${type};base64,${base64}`;
    this.picture.alt = `${this.set.title}: ${name}`;
  }

  play() {
    this.playButton.textContent = 'Pause';
    if (this.index === this.set.frames.length - 1) this.show(0);
    this.timer = setInterval(() => {
      this.show(this.index + 1);
      if (this.index === this.set.frames.length - 1) this.stop();
    }, frame_ms);
  }

  stop() {
    clearInterval(this.timer);
    this.timer = null;
    this.playButton.textContent = 'Play';
  }
}

export function frames(report, lines) {
  return report.frames.map((set) => new Frames(set, lines).element);
}
