// The list of trials: sorted by any column, filtered by words and classes, in pages.

import { el, svg } from './dom.js';

const pageSize = 25;
const sparkWidth = 90;
const sparkHeight = 22;

// V_t, then T_t, over the trial's time; all trials on one scale.
function sparkline(values, [low, high], label) {
  const span = high - low || 1;
  const x = (i) => (1 + (i * (sparkWidth - 2)) / Math.max(1, values.length - 1)).toFixed(1);
  const y = (v) => (sparkHeight - 2 - ((v - low) * (sparkHeight - 4)) / span).toFixed(1);
  let path = '';
  let pen = 'M';
  values.forEach((value, i) => {
    if (value === null) {
      pen = 'M';
      return;
    }
    path += `${pen}${x(i)} ${y(value)}`;
    pen = 'L';
  });
  return svg('svg', { class: 'spark', width: sparkWidth, height: sparkHeight, role: 'img', 'aria-label': label },
    low < 0 && high > 0
      ? svg('line', { class: 'zero', x1: 0, x2: sparkWidth, y1: y(0), y2: y(0) }) : null,
    svg('path', { d: path }));
}

const words = new Intl.Collator('en', { numeric: true });

function compare(a, b) {
  if (typeof a === 'number' && typeof b === 'number') return a - b;
  return words.compare(a, b);
}

function shown(value, column) {
  if (value === null) return 'NA';
  return typeof value === 'number' && column.decimals >= 0 ? value.toFixed(column.decimals) : String(value);
}

// Columns whose few values make a choice worth offering.
function choices(trials) {
  return trials.columns.map((column, c) => ({ column, c }))
    .filter(({ column }) => column.choice)
    .map(({ column, c }) => ({
      column, c, values: [...new Set(trials.rows.map((row) => row[c]))].sort((a, b) => compare(a ?? '', b ?? '')),
    }))
    .filter(({ values }) => values.length > 1);
}

export class TrialList {
  constructor(trials, open) {
    this.trials = trials;
    this.open = open;
    this.sort = { column: 0, descending: false };
    this.words = '';
    this.chosen = new Map();
    this.page = 0;
    this.status = el('p', { role: 'status', class: 'status' });
    this.body = el('tbody');
    this.head = el('tr');
    this.pager = el('div', { class: 'pager' });
    this.element = el('div', { class: 'card' },
      this.filters(), this.status,
      el('div', { class: 'scroll', role: 'region', tabindex: 0, 'aria-label': 'List of trials' },
        el('table', { id: 'trial-list' },
          el('caption', { class: 'unseen' }, 'Trials; the buttons in the header sort them'),
          el('thead', {}, this.head), this.body)),
      this.pager);
    this.makeHead();
    this.update();
  }

  filters() {
    const search = el('input', { type: 'search', id: 'trial-filter', autocomplete: 'off', oninput: () => {
      this.words = search.value.toLowerCase();
      this.first();
    } });
    const selects = choices(this.trials).map(({ column, c, values }) => {
      const select = el('select', { id: `filter-${column.name}`, onchange: () => {
        if (select.value === '') this.chosen.delete(c);
        else this.chosen.set(c, values[Number(select.value)]);
        this.first();
      } }, el('option', { value: '' }, 'all'),
      values.map((value, i) => el('option', { value: i }, shown(value, column))));
      return el('label', {}, `${column.heading} `, select);
    });
    return el('form', { class: 'filters', role: 'search', onsubmit: (event) => event.preventDefault() },
      el('label', {}, 'Find ', search), selects);
  }

  makeHead() {
    this.headers = this.trials.columns.map((column, c) => {
      const unit = column.unit ? ` [${column.unit}]` : '';
      const button = el('button', { type: 'button', title: column.doc || null, onclick: () => {
        const again = this.sort.column === c;
        this.sort = { column: c, descending: again && !this.sort.descending };
        this.first();
      } }, column.heading + unit, el('span', { class: 'arrow', 'aria-hidden': 'true' }));
      return el('th', { scope: 'col', class: column.numeric ? 'number' : null }, button);
    });
    this.head.append(this.headers[0], el('th', { scope: 'col' }, 'V_t, then T_t over time'), ...this.headers.slice(1));
  }

  first() {
    this.page = 0;
    this.update();
  }

  // Indices of the trials that pass the filter, in order. Missing values come last either way.
  order() {
    const { rows } = this.trials;
    const wanted = this.words.split(/\s+/).filter(Boolean);
    const passes = (row) => [...this.chosen].every(([c, value]) => row[c] === value)
      && (wanted.length === 0 || wanted.every((word) =>
        row.some((cell) => typeof cell === 'string' && cell.toLowerCase().includes(word))));
    const { column, descending } = this.sort;
    return rows.map((row, index) => index).filter((index) => passes(rows[index])).sort((i, j) => {
      const a = rows[i][column];
      const b = rows[j][column];
      if (a === null || b === null) return (a === null) - (b === null) || i - j;
      return (descending ? compare(b, a) : compare(a, b)) || i - j;
    });
  }

  row(index) {
    const { columns, rows, spark, spark_range: range } = this.trials;
    const row = rows[index];
    const cells = row.map((value, c) => {
      const kind = (columns[c].numeric ? 'number' : '') + (value === null ? ' missing' : '');
      if (c > 0) return el('td', { class: kind || null }, shown(value, columns[c]));
      return el('th', { scope: 'row' }, el('button', {
        type: 'button', class: 'link', 'aria-label': `Open trial ${value}`, onclick: () => this.open(index),
      }, value));
    });
    const picture = spark.length ? sparkline(spark[index], range, `Corridor value and certificate of ${row[0]}`) : 'NA';
    return el('tr', { 'data-trial': row[0], class: this.current === index ? 'current' : null },
      cells[0], el('td', {}, picture), cells.slice(1));
  }

  mark(index) {
    this.current = index;
    for (const row of this.body.children) {
      row.classList.toggle('current', row.dataset.trial === this.trials.rows[index][0]);
    }
  }

  update() {
    const order = this.order();
    const pages = Math.max(1, Math.ceil(order.length / pageSize));
    this.page = Math.min(this.page, pages - 1);
    const from = this.page * pageSize;
    const part = order.slice(from, from + pageSize);
    this.headers.forEach((header, c) => {
      const sorted = this.sort.column === c;
      if (sorted) header.setAttribute('aria-sort', this.sort.descending ? 'descending' : 'ascending');
      else header.removeAttribute('aria-sort');
      header.querySelector('.arrow').textContent = sorted ? (this.sort.descending ? ' ▼' : ' ▲') : '';
    });
    this.status.textContent = order.length === 0 ? 'No trial passes the filter.'
      : `${from + 1} to ${from + part.length} of ${order.length} trials`
        + (order.length < this.trials.rows.length ? `, filtered from ${this.trials.rows.length}` : '');
    this.body.replaceChildren(...part.map((index) => this.row(index)));
    const step = (label, page, possible) => el('button', {
      type: 'button', class: 'small', disabled: !possible, onclick: () => {
        this.page = page;
        this.update();
        this.pager.querySelector('button:not([disabled])')?.focus();
      },
    }, label);
    this.pager.replaceChildren(
      step('First', 0, this.page > 0), step('Previous', this.page - 1, this.page > 0),
      el('span', {}, `page ${this.page + 1} of ${pages}`),
      step('Next', this.page + 1, this.page + 1 < pages), step('Last', pages - 1, this.page + 1 < pages));
  }
}
