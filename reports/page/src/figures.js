// Figures: Vega-Lite specifications drawn without evaluating code, each with the numbers behind it.

import embed from 'vega-embed';
import { expressionInterpreter } from 'vega-interpreter';
import { csvParseRows } from './csv.js';
import { colour, el, onThemeChange, saveButton } from './dom.js';
import { keyElement, takeKey } from './figure_key.js';
import { tableElement } from './tables.js';

const shownRows = 200;

function theme() {
  const ink = colour('--ink');
  const muted = colour('--muted');
  const grid = colour('--grid');
  const font = 'system-ui, sans-serif';
  return {
    background: 'transparent',
    font,
    view: { stroke: grid },
    axis: {
      labelColor: ink, titleColor: ink, gridColor: grid, domainColor: muted, tickColor: muted,
      labelFontSize: 12, titleFontSize: 12, titleFontWeight: 'normal', labelLimit: 220,
      labelOverlap: 'parity', labelSeparation: 8, titleLimit: 320,
    },
    axisDiscrete: { labelOverlap: false },
    axisPoint: { labelOverlap: false },
    axisBand: { labelOverlap: false },
    legend: {
      labelColor: ink, titleColor: ink, labelFontSize: 12, titleFontSize: 12, titleFontWeight: 'normal',
      orient: 'bottom', direction: 'horizontal', gradientLength: 140,
    },
    title: {
      color: ink, fontSize: 13, fontWeight: 'normal', anchor: 'start', subtitleColor: muted, subtitleFontSize: 12,
    },
    header: { labelColor: ink, titleColor: ink },
    text: { color: ink, strokeWidth: 0 },
    style: {
      ink: { color: ink, stroke: ink },
      muted: { color: muted, stroke: muted },
      faint: { color: grid, stroke: grid },
      'ink-text': { color: ink },
      'muted-text': { color: muted },
      'faint-text': { color: grid },
      'filled-faint': { color: colour('--wall'), fill: colour('--wall') },
    },
  };
}

// Rows of different heights are parts of one picture: what stood below a panel follows it.
function inOneColumn(panels, columns) {
  if (new Set(panels.map((panel) => panel.height)).size === 1) return panels;
  return Array.from({ length: columns }, (_, c) => panels.filter((_panel, i) => i % columns === c)).flat();
}

// A view that fits the width there is: panels beside each other only where they can be read.
function fitted(spec, width) {
  const copy = structuredClone(spec);
  takeKey(copy);
  copy.$schema = 'https://vega.github.io/schema/vega-lite/v6.json'; // The same grammar, without a warning.
  copy.config = theme();
  // The page has the title above the figure; what the data are stays in it.
  copy.title = spec.title?.subtitle ? { text: '', subtitle: spec.title.subtitle, anchor: 'start' } : '';
  if (Array.isArray(copy.concat)) {
    const wanted = copy.columns ?? 1;
    const columns = Math.max(1, Math.min(wanted, Math.floor(width / 300)));
    if (columns === 1) copy.concat = inOneColumn(copy.concat, wanted);
    const room = Math.max(120, Math.floor(width / columns) - 90);
    copy.columns = columns;
    for (const panel of copy.concat) {
      if (typeof panel.width !== 'number') continue;
      panel.width = room;
    }
    copy.autosize = { type: 'pad' };
  } else if (typeof copy.width === 'number' && typeof copy.height === 'number') {
    // Both scales are one: a map. The legend of its colours stands below it where there is no room beside it.
    const beside = width > 480;
    for (const layer of copy.layer) {
      if (layer.encoding.stroke?.legend && !beside) layer.encoding.stroke.legend.orient = 'bottom';
    }
    const room = Math.min(width - (beside ? 170 : 60), 1.6 * copy.width);
    copy.height *= room / copy.width;
    copy.width = room;
    copy.autosize = { type: 'pad' };
  } else {
    copy.width = 'container';
    copy.autosize = { type: 'fit-x', contains: 'padding', resize: true };
  }
  return copy;
}

class Figure {
  constructor(figure) {
    this.figure = figure;
    this.view = null;
    this.plot = el('div', { class: 'plot', role: 'img', 'aria-label': `${figure.title}. ${figure.caption}` });
    this.element = el('figure', { class: figure.wide ? 'card wide' : 'card', id: `figure-${figure.id}`, 'data-state': 'waiting' },
      el('h3', {}, figure.title),
      keyElement(takeKey(structuredClone(figure.spec))),
      el('div', { class: 'scroll plain' }, this.plot),
      el('figcaption', {}, figure.caption),
      this.numbers(),
      el('p', { class: 'actions' },
        saveButton('Save numbers as CSV', `${figure.name}.csv`, 'text/csv', () => figure.csv),
        saveButton('Save Vega-Lite', `${figure.name}.vl.json`, 'application/json',
          () => JSON.stringify(figure.spec, null, 2))));
  }

  numbers() {
    const details = el('details', {}, el('summary', {}, 'The numbers behind it'));
    details.addEventListener('toggle', () => {
      if (!details.open || details.childElementCount > 1) return;
      const [names, ...rows] = csvParseRows(this.figure.csv);
      const table = {
        columns: names.map((name) => ({ heading: name, numeric: false })),
        rows: rows.slice(0, shownRows).map((cells) => cells.map((cell) => (cell === '' ? 'NA' : cell))),
      };
      details.append(tableElement(table, `Numbers of: ${this.figure.title}`));
      if (rows.length > shownRows) {
        details.append(el('p', {}, `The first ${shownRows} of ${rows.length} rows; the CSV has them all.`));
      }
    });
    return details;
  }

  async draw() {
    const width = this.plot.clientWidth;
    this.view?.finalize();
    const spec = fitted(this.figure.spec, width);
    try {
      const result = await embed(this.plot, spec, {
        actions: false, defaultStyle: false, renderer: 'svg', ast: true, expr: expressionInterpreter,
        tooltip: false,
      });
      this.view = result.view;
      this.width = width;
      const picture = this.plot.querySelector('svg');
      picture?.setAttribute('aria-hidden', 'true');
      this.element.dataset.state = 'drawn';
    } catch (error) {
      this.element.dataset.state = 'failed';
      this.plot.replaceChildren(el('p', { class: 'notice' }, `This figure cannot be drawn: ${error.message}`));
    }
  }
}

// Their frames at once; `start` draws what is near the reader first, the rest when there is nothing else
// to do.
export function figures(report) {
  if (report.figures.length === 0) {
    return { content: [el('p', {}, 'These results hold no figure.')], start() {} };
  }
  const all = report.figures.map((figure) => new Figure(figure));
  return { content: [el('div', { class: 'figures' }, all.map((figure) => figure.element))], start: () => start(all) };
}

function start(all) {
  const waiting = new Set(all);
  const draw = (figure) => (waiting.delete(figure) ? figure.draw() : undefined);
  const near = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      near.unobserve(entry.target);
      draw(all.find((figure) => figure.element === entry.target));
    }
  }, { rootMargin: '400px' });
  all.forEach((figure) => near.observe(figure.element));

  const whenIdle = (work) => requestIdleCallback(work, { timeout: 500 });
  const drawRest = async () => {
    const [next] = waiting;
    if (next === undefined) return;
    await draw(next);
    whenIdle(drawRest);
  };
  whenIdle(drawRest);

  const redraw = () => all.filter((figure) => !waiting.has(figure)).forEach((figure) => figure.draw());
  onThemeChange(redraw);
  let settled = 0;
  addEventListener('resize', () => {
    clearTimeout(settled);
    settled = setTimeout(() => {
      all.filter((figure) => figure.view && figure.width !== figure.plot.clientWidth)
        .forEach((figure) => figure.draw());
    }, 150);
  });
}
