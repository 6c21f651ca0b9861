// The key of a figure as a list beside it: one entry a class, however many marks and channels show it.

import { el, svg } from './dom.js';

const shapes = {
  circle: 'M6 2A4 4 0 1 1 6 10A4 4 0 1 1 6 2Z', square: 'M2.5 2.5H9.5V9.5H2.5Z', 'triangle-up': 'M6 1.5L10.5 10H1.5Z',
  'triangle-down': 'M6 10.5L1.5 2H10.5Z', diamond: 'M6 1L11 6L6 11L1 6Z', cross: 'M4.5 1.5H7.5V4.5H10.5V7.5H7.5V10.5H4.5V7.5H1.5V4.5H4.5Z',
};
const paths = ['line', 'rule', 'trail'];

function layersOf(view) {
  return [...(view.layer ?? []), ...(view.concat ?? []).flatMap(layersOf)];
}

// Takes the legends of classes out of `spec` and returns how each class is drawn. Gradients keep theirs.
export function takeKey(spec) {
  const classes = new Map();
  for (const { mark, encoding = {} } of layersOf(spec)) {
    const { color } = encoding;
    const drawn = color?.legend?.values;
    for (const channel of ['color', 'strokeDash', 'shape']) {
      if (encoding[channel]?.scale?.domain && encoding[channel].type === 'nominal') encoding[channel].legend = null;
    }
    if (!color?.scale?.domain || color.type !== 'nominal') continue;
    const { domain, range } = color.scale;
    const kind = mark.type ?? mark;
    domain.forEach((name, i) => {
      if ((color.datum !== undefined && color.datum !== name) || (drawn && !drawn.includes(name))) return;
      const entry = classes.get(name) ?? { name, colour: range[i], order: i };
      if (paths.includes(kind)) {
        entry.line = true;
        entry.dash = encoding.strokeDash?.scale?.range?.[i] ?? entry.dash;
      } else if (kind === 'point') {
        entry.shape = encoding.shape?.scale?.range?.[i] ?? 'circle';
        entry.hollow = mark.filled === false;
      } else {
        entry.area = true;
      }
      classes.set(name, entry);
    });
  }
  return [...classes.values()].sort((a, b) => a.order - b.order);
}

function swatch({ colour, line, dash, shape, hollow, area }) {
  return svg('svg', { width: 30, height: 12, viewBox: '0 0 30 12', 'aria-hidden': 'true' },
    area ? svg('rect', { x: 0, y: 1, width: 30, height: 10, fill: colour, 'fill-opacity': 0.25 }) : null,
    line ? svg('line', { x1: 0, x2: 30, y1: 6, y2: 6, stroke: colour, 'stroke-width': 2.2, 'stroke-dasharray': dash?.join(' ') || null }) : null,
    shape ? svg('path', { d: shapes[shape] ?? shapes.circle, transform: 'translate(9 0)', stroke: colour, 'stroke-width': 1.4, fill: hollow ? 'none' : colour }) : null);
}

export function keyElement(classes) {
  if (classes.length === 0) return null;
  return el('ul', { class: 'key' }, classes.map((entry) => el('li', {}, swatch(entry), entry.name)));
}
