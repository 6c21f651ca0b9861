// One trial, tick by tick: map and time series with one cursor, played or stepped through.

import { decoded, inflated } from './blocks.js';
import { el, onThemeChange } from './dom.js';
import { TrialMap } from './map.js';
import { SeriesPlots } from './series_plots.js';

const frame_ms = 40;
const speeds = [1, 4, 16, 64];

// Where a value is missing as well as where the trial has no such column.
function shown(value, column) {
  if (value === null || value === undefined) return 'NA';
  return value.toFixed(column.decimals) + (column.unit ? ` ${column.unit}` : '');
}

// Where the robot was at the first of each run of ticks with a ray in contact.
function touched(contacts, xs, ys) {
  return contacts.flatMap((count, i) =>
    (count > 0 && !(contacts[i - 1] > 0) && xs[i] !== null && ys[i] !== null ? [[xs[i], ys[i]]] : []));
}

export class TrialViewer {
  constructor(report, lines) {
    this.report = report;
    this.lines = lines;
    this.element = el('section', { class: 'card viewer', id: 'trial', hidden: true, 'aria-labelledby': 'trial-title' });
    onThemeChange(() => this.redraw());
    let settled = 0;
    addEventListener('resize', () => {
      clearTimeout(settled);
      settled = setTimeout(() => this.redraw(), 150);
    });
  }

  async open(index, name) {
    this.stop();
    const [worldNumber, block] = this.lines.series[index].split(' ');
    const trial = await inflated(block);
    const world = worldNumber === '' ? null : await inflated(this.lines.worlds[Number(worldNumber)]);
    const series = {};
    for (const [column, coded] of Object.entries(trial.series)) series[column] = decoded(coded);
    this.series = series;
    this.tick = 0;
    this.last = series.time_s.length - 1;
    const pick = (tick) => this.show(tick);
    // A column without any value is not sent.
    const column = (name) => series[name] ?? series.time_s.map(() => null);
    const map = {
      touched: touched(column('contacts'), column('x_m'), column('y_m')),
      polygons: [], discs: [], beams: [], bounds: null, start: null, goal: null, ...(world ?? {}), ...trial.map,
    };
    this.map = new TrialMap(map, column('x_m'), column('y_m'), column('yaw_rad'), pick);
    const panels = this.report.series.panels.map((panel) => ({
      ...panel, columns: panel.columns.filter((column) => series[column.name]?.some((value) => value !== null)),
    })).filter((panel) => panel.columns.length > 0);
    this.plots = new SeriesPlots(panels, series, pick);
    this.columns = this.report.series.readout.filter((column) => series[column.name]);
    this.values = this.columns.map(() => el('dd'));
    this.slider = el('input', {
      type: 'range', min: 0, max: this.last, step: 1, value: 0, id: 'tick', oninput: () => this.show(Number(this.slider.value)),
    });
    this.playButton = el('button', { type: 'button', id: 'play', onclick: () => (this.timer ? this.stop() : this.play()) }, 'Play');
    this.speed = el('select', { id: 'speed' }, speeds.map((speed) => el('option', { value: speed, selected: speed === 4 }, `${speed}×`)));
    const step = (label, by) => el('button', { type: 'button', 'aria-label': label, onclick: () => {
      this.stop();
      this.show(Math.min(this.last, Math.max(0, this.tick + by)));
    } }, by < 0 ? '‹ Step' : 'Step ›');
    const kept = trial.ticks === this.last + 1 ? `All ${trial.ticks} ticks.`
      : `${this.last + 1} of ${trial.ticks} ticks: ${this.report.series.rule}`;
    this.element.replaceChildren(
      el('h3', { id: 'trial-title', tabindex: -1 }, `Trial ${name}`),
      this.report.synthetic ? el('p', { class: 'made' }, this.report.synthetic) : '',
      el('p', { class: 'facts' }, trial.facts),
      el('div', { class: 'player', role: 'group', 'aria-label': 'Step through time' },
        this.playButton, step('Step back', -1), step('Step forward', 1),
        el('label', { class: 'grow' }, 'Tick ', this.slider), el('label', {}, 'Speed ', this.speed)),
      el('div', { class: 'panes' },
        el('div', {}, this.map.element, el('dl', { class: 'readout', id: 'readout' }, this.columns.map((column, i) =>
          el('div', {}, el('dt', {}, column.heading), this.values[i])))),
        this.plots.element),
      el('p', { class: 'source' }, kept));
    this.element.hidden = false;
    this.plots.draw();
    this.show(0);
    this.element.querySelector('h3').focus({ preventScroll: true });
    this.element.scrollIntoView({ block: 'start' });
  }

  redraw() {
    if (!this.plots) return;
    this.plots.draw();
    this.show(this.tick);
  }

  show(tick) {
    this.tick = tick;
    this.slider.value = tick;
    this.slider.setAttribute('aria-valuetext', `${this.series.time_s[tick].toFixed(2)} s`);
    this.map.show(tick);
    this.plots.show(tick);
    this.columns.forEach((column, i) => {
      this.values[i].textContent = shown(this.series[column.name][tick], column);
    });
  }

  // The trial's own clock, times the speed chosen.
  play() {
    if (this.tick === this.last) this.show(0);
    this.playButton.textContent = 'Pause';
    let clock = this.series.time_s[this.tick];
    this.timer = setInterval(() => {
      clock += (frame_ms / 1000) * Number(this.speed.value);
      let next = this.tick;
      while (next < this.last && this.series.time_s[next + 1] <= clock) ++next;
      if (next !== this.tick) this.show(next);
      if (next === this.last) this.stop();
    }, frame_ms);
  }

  stop() {
    clearInterval(this.timer);
    this.timer = null;
    if (this.playButton) this.playButton.textContent = 'Play';
  }
}
