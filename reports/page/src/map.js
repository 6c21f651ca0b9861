// The map of a trial: course, odometry, corridor graph, contacts, bottleneck, witness, place of issuance, the robot now.

import { el, svg } from './dom.js';
import { gradientColour } from './gradient.js';

const margin = 0.4; // m around what is drawn
const gradientSteps = 12;

function bounds(map, xs, ys) {
  const box = { x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity };
  const add = (x, y) => {
    if (x === null || y === null) return;
    box.x0 = Math.min(box.x0, x);
    box.x1 = Math.max(box.x1, x);
    box.y0 = Math.min(box.y0, y);
    box.y1 = Math.max(box.y1, y);
  };
  xs.forEach((x, i) => add(x, ys[i]));
  for (const { x, y, r } of map.discs) {
    add(x - r, y - r);
    add(x + r, y + r);
  }
  if (map.bounds) {
    add(map.bounds[0], map.bounds[1]);
    add(map.bounds[2], map.bounds[3]);
  }
  for (const polygon of map.polygons) polygon.forEach(([x, y]) => add(x, y));
  for (const [x1, y1, x2, y2] of map.edges) {
    add(x1, y1);
    add(x2, y2);
  }
  // Nothing with a place: a map of nothing, not one without bounds.
  return box.x0 <= box.x1 ? box : { x0: 0, x1: 1, y0: 0, y1: 1 };
}

function points(list) {
  return list.map(([x, y]) => `${x},${-y}`).join(' ');
}

function region(shape, kind) {
  if (!shape) return null;
  return shape.polygon ? svg('polygon', { class: kind, points: points(shape.polygon) })
    : svg('circle', { class: kind, cx: shape.x, cy: -shape.y, r: shape.r });
}

function edgeRange(edges) {
  const margins = edges.map((edge) => edge[4]).filter((value) => value !== null);
  return margins.length ? [Math.min(...margins), Math.max(...margins)] : [0, 1];
}

function key(map, range) {
  const item = (kind, shape, words) => el('li', {},
    svg('svg', { class: 'swatch', viewBox: '0 0 24 12', width: 24, height: 12, 'aria-hidden': 'true' }, shape), words);
  const line = (kind) => svg('line', { class: kind, x1: 1, x2: 23, y1: 6, y2: 6 });
  const items = [];
  if (map.polygons.length + map.discs.length) {
    items.push(item('', svg('rect', { class: 'wall', x: 3, y: 1, width: 18, height: 10 }), 'course'));
  }
  if (map.beams.length) items.push(item('', svg('circle', { class: 'beam', cx: 12, cy: 6, r: 2 }), 'sides proved free'));
  items.push(item('', line('odometry'), 'odometry'));
  if (map.start) items.push(item('', svg('rect', { class: 'start', x: 3, y: 1, width: 18, height: 10 }), 'start S'));
  if (map.goal) items.push(item('', svg('rect', { class: 'goal', x: 3, y: 1, width: 18, height: 10 }), 'goal G'));
  if (map.bottleneck) {
    items.push(item('', svg('circle', { class: 'bottleneck', cx: 12, cy: 6, r: 5 }), 'bottleneck'));
  }
  if (map.witness.length) items.push(item('', line('witness'), 'witness, o where its margin is decided'));
  if (map.touched.length) {
    items.push(item('', svg('path', { class: 'contact', d: 'M12 2L17 10H7Z' }), 'rays in contact'));
  }
  if (map.issued) {
    items.push(item('', svg('path', { class: 'issued', d: 'M12 1L17 6L12 11L7 6Z' }), 'issued here'));
  }
  if (map.edges.length) {
    const bar = svg('svg', { width: 96, height: 10, viewBox: '0 0 96 10', 'aria-hidden': 'true' });
    for (let i = 0; i < gradientSteps; ++i) {
      bar.append(svg('rect', { x: i * 8, y: 0, width: 8.5, height: 10, fill: gradientColour(i, 0, gradientSteps - 1) }));
    }
    items.push(el('li', {}, `edge margin ${range[0].toFixed(2)} `, bar, ` ${range[1].toFixed(2)} m`));
  }
  return el('ul', { class: 'key' }, items);
}

export class TrialMap {
  // `xs`, `ys`, `yaws` by tick, null where it is not known; `pick(tick)` when the reader points at the path.
  constructor(map, xs, ys, yaws, pick) {
    this.xs = xs;
    this.ys = ys;
    this.yaws = yaws;
    this.box = bounds(map, xs, ys);
    const { x0, x1, y0, y1 } = this.box;
    const width = x1 - x0 + 2 * margin;
    const height = y1 - y0 + 2 * margin;
    this.unit = Math.max(width, height) / 500; // about a pixel
    const path = xs.map((x, i) => [x, ys[i]]).filter(([x, y]) => x !== null && y !== null);
    const range = edgeRange(map.edges);
    this.past = svg('polyline', { class: 'past' });
    this.robot = svg('path', { class: 'robot', d: `M${9} 0L${-6} 6L${-3} 0L${-6} -6Z` });
    const cross = 6 * this.unit;
    this.drawing = svg('svg', {
      class: 'map', role: 'img', preserveAspectRatio: 'xMidYMid meet',
      viewBox: `${x0 - margin} ${-y1 - margin} ${width} ${height}`,
      'aria-label': 'Map of the trial: course, odometry, corridor graph by edge margin, contacts, bottleneck, witness, place of issuance',
    },
    map.bounds ? svg('rect', { class: 'bounds', x: map.bounds[0], y: -map.bounds[3],
      width: map.bounds[2] - map.bounds[0], height: map.bounds[3] - map.bounds[1] }) : null,
    region(map.start, 'start'), region(map.goal, 'goal'),
    map.polygons.map((polygon) => svg('polygon', { class: 'wall', points: points(polygon) })),
    map.discs.map(({ x, y, r }) => svg('circle', { class: 'wall', cx: x, cy: -y, r })),
    map.beams.map(([x, y]) => svg('circle', { class: 'beam', cx: x, cy: -y, r: this.unit })),
    svg('polyline', { class: 'odometry', points: points(path) }), this.past,
    map.edges.map(([ax, ay, bx, by]) => svg('line', { class: 'casing', x1: ax, y1: -ay, x2: bx, y2: -by })),
    map.edges.map(([ax, ay, bx, by, value]) => svg('line', {
      class: 'edge', x1: ax, y1: -ay, x2: bx, y2: -by,
      stroke: value === null ? 'gray' : gradientColour(value, range[0], range[1]),
    })),
    map.touched.map(([x, y]) => svg('path', { class: 'contact',
      d: `M${x} ${-y - 0.8 * cross}l${0.8 * cross} ${1.4 * cross}h${-1.6 * cross}Z` })),
    map.issued ? svg('path', { class: 'issued',
      d: `M${map.issued.x} ${-map.issued.y - 1.6 * cross}l${cross * 1.3} ${cross * 1.6}l${-cross * 1.3} ${cross * 1.6}l${-cross * 1.3} ${-cross * 1.6}Z` }) : null,
    map.bottleneck ? svg('circle', { class: 'bottleneck', cx: map.bottleneck.x, cy: -map.bottleneck.y, r: 10 * this.unit }) : null,
    map.witness.length ? svg('polyline', { class: 'witness', points: points(map.witness) }) : null,
    map.witnessBottleneck ? svg('circle', { class: 'witness', cx: map.witnessBottleneck.x, cy: -map.witnessBottleneck.y, r: 6 * this.unit }) : null,
    this.robot);
    this.drawing.addEventListener('click', (event) => pick(this.nearest(event)));
    this.element = el('div', { class: 'map-box' }, this.drawing, key(map, range),
      map.note ? el('p', { class: 'source' }, map.note) : null);
  }

  nearest(event) {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.drawing.getScreenCTM().inverse());
    let best = 0;
    let least = Infinity;
    this.xs.forEach((x, i) => {
      const far = x === null || this.ys[i] === null ? Infinity : (x - at.x) ** 2 + (this.ys[i] + at.y) ** 2;
      if (far < least) {
        least = far;
        best = i;
      }
    });
    return best;
  }

  show(tick) {
    const x = this.xs[tick];
    const y = this.ys[tick];
    const yaw = this.yaws[tick];
    // An arrow without a heading would be a guess.
    const known = x !== null && y !== null && yaw !== null;
    this.robot.setAttribute('visibility', known ? 'visible' : 'hidden');
    if (known) {
      const degrees = (-yaw * 180) / Math.PI;
      this.robot.setAttribute('transform', `translate(${x} ${-y}) rotate(${degrees}) scale(${this.unit * 1.4})`);
    }
    const past = [];
    for (let i = 0; i <= tick; ++i) if (this.xs[i] !== null && this.ys[i] !== null) past.push([this.xs[i], this.ys[i]]);
    this.past.setAttribute('points', points(past));
  }
}
