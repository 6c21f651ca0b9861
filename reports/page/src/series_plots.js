// The time series of a trial: plots with one cursor, linked to the map by tick.

import uPlot from 'uplot';
import { colour, el, svg } from './dom.js';

// Okabe and Ito's colours as the figures have them, with a dash each so that print tells them apart.
const lines = [
  { colour: '--class-1', dash: [] },
  { colour: '--class-2', dash: [8, 4] },
  { colour: '--class-3', dash: [2, 3] },
  { colour: '--class-4', dash: [10, 3, 2, 3] },
];

function options(panel, width, height, cursorMoved, ready) {
  const axis = {
    stroke: colour('--ink'), grid: { stroke: colour('--grid'), width: 1 },
    ticks: { stroke: colour('--grid'), width: 1 }, font: '12px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif',
  };
  return {
    width, height,
    legend: { show: false },
    cursor: { drag: { x: true, y: false }, sync: { key: 'tick' }, points: { size: 7 } },
    scales: { x: { time: false } },
    axes: [
      { ...axis, label: 'Time [s]', labelSize: 20, size: 32 },
      { ...axis, label: `${panel.title}${panel.unit ? ` [${panel.unit}]` : ''}`, labelSize: 20, size: 46 },
    ],
    series: [{}, ...panel.columns.map((column, i) => ({
      label: column.heading, stroke: colour(lines[i % lines.length].colour), width: 1.8,
      dash: lines[i % lines.length].dash, points: { show: false }, spanGaps: false,
      paths: column.steps ? uPlot.paths.stepped({ align: 1 }) : undefined,
    }))],
    hooks: { setCursor: [cursorMoved], ready: [ready] },
  };
}

function key(panel) {
  return el('ul', { class: 'key' }, panel.columns.map((column, i) =>
    el('li', {}, svg('svg', { width: 36, height: 8, 'aria-hidden': 'true' },
      svg('line', { class: `stroke-${(i % lines.length) + 1}`, x1: 0, x2: 36, y1: 4, y2: 4,
        'stroke-dasharray': lines[i % lines.length].dash.join(' ') || null })), column.heading)));
}

export class SeriesPlots {
  constructor(panels, series, pick) {
    this.panels = panels;
    this.series = series;
    this.pick = pick;
    this.silent = false;
    this.tick = 0;
    this.plots = [];
    this.boxes = panels.map((panel) => el('div', { class: 'series-plot', role: 'img',
      'aria-label': `${panel.title} over time: ${panel.columns.map((column) => column.heading).join(', ')}` }));
    this.element = el('div', { class: 'series' },
      panels.map((panel, i) => el('div', {}, el('h4', {}, panel.title), key(panel), this.boxes[i])));
  }

  draw() {
    this.plots.forEach((plot) => plot.destroy());
    const width = Math.max(240, this.element.clientWidth);
    const moved = (plot) => {
      if (!this.silent && plot.cursor.idx !== null && plot.cursor.event) this.pick(plot.cursor.idx);
    };
    // A plot has no scales before it is ready, which is after this turn.
    const ready = (plot) => this.place(plot);
    this.plots = this.panels.map((panel, i) => new uPlot(options(panel, width, i === 0 ? 240 : 150, moved, ready),
      [this.series.time_s, ...panel.columns.map((column) => this.series[column.name])], this.boxes[i]));
  }

  show(tick) {
    this.tick = tick;
    this.plots.filter((plot) => plot.status === 1).forEach((plot) => this.place(plot));
  }

  place(plot) {
    this.silent = true;
    plot.setCursor({ left: plot.valToPos(this.series.time_s[this.tick], 'x'), top: 0 }, false);
    this.silent = false;
  }
}
