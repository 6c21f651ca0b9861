// Tables as tables: cells come printed, the same digits as in text and LaTeX.

import { el, saveButton } from './dom.js';

function heading(column) {
  const unit = column.unit ? ` [${column.unit}]` : '';
  return el('th', { scope: 'col', class: column.numeric ? 'number' : null }, column.heading + unit);
}

// A row's name may break behind an underscore.
function breakable(text) {
  return text.split(/(?<=_)/).flatMap((part, i) => (i === 0 ? [part] : [el('wbr'), part]));
}

function row(table, cells) {
  return el('tr', {}, cells.map((text, c) => {
    const missing = text === 'NA' ? ' missing' : '';
    const kind = (table.columns[c].numeric ? 'number' : '') + missing;
    return el(c === 0 ? 'th' : 'td', { scope: c === 0 ? 'row' : null, class: kind || null }, c === 0 ? breakable(text) : text);
  }));
}

const narrow = matchMedia('(max-width: 600px)');

// On a narrow screen a row's name and the score come first: the rest is to the right, out of sight.
function columnOrder(columns) {
  const order = columns.map((_, c) => c);
  const score = ['auc', 'c'].map((name) => columns.findIndex((column) => column.name === name)).find((c) => c > 0);
  if (!narrow.matches || score === undefined) return order;
  const name = order.find((c) => c < score && !columns[c].numeric && columns[c].name !== 'panel') ?? 0;
  return [name, score, ...order.filter((c) => c !== name && c !== score)];
}

function ordered(table) {
  const order = columnOrder(table.columns);
  const pick = (list) => order.map((c) => list[c]);
  return { columns: pick(table.columns), rows: table.rows.map(pick) };
}

export function tableElement(table, caption) {
  const element = el('table', {});
  const fill = () => {
    const shown = ordered(table);
    element.replaceChildren(
      el('caption', { class: 'unseen' }, caption),
      el('thead', {}, el('tr', {}, shown.columns.map(heading))),
      el('tbody', {}, shown.rows.map((cells) => row(shown, cells))));
  };
  fill();
  narrow.addEventListener('change', fill);
  return el('div', { class: 'scroll', role: 'region', tabindex: 0, 'aria-label': caption }, element);
}

function tableSection(table) {
  const n = table.n === null ? '' : ` (n = ${table.n})`;
  return el('section', { class: 'card', id: `table-${table.id}` },
    el('h4', {}, table.title + n),
    tableElement(table, table.title),
    table.footnotes.length
      ? el('ul', { class: 'footnotes' }, table.footnotes.map((note) => el('li', {}, note))) : null,
    el('p', { class: 'actions' },
      saveButton('Save as CSV', `${table.name}.csv`, 'text/csv', () => table.csv)));
}

// The tables of one folder of results: those to read first, then the others behind a line.
function group(name, title, all) {
  const main = all.filter((table) => table.main);
  const further = all.filter((table) => !table.main);
  return [
    el('h3', { class: 'group', id: `group-${name}` }, title),
    main.map(tableSection),
    further.length === 0 ? null : el('details', { class: 'more' },
      el('summary', {}, further.length === 1 ? `One more table: ${further[0].title}` : `${further.length} more tables: ${further.map((table) => table.title).join('; ')}`),
      further.map(tableSection)),
  ].flat();
}

export function tables(report) {
  if (report.tables.length === 0) {
    return [el('p', {}, 'These results hold no table.')];
  }
  const names = [...new Set(report.tables.map((table) => table.source))];
  const titleOf = (name) => report.tables.find((table) => table.source === name).group;
  const list = names.length < 2 ? null
    : el('nav', { 'aria-label': 'Tables by result', class: 'contents' }, el('ul', {}, names.map((name) =>
        el('li', {}, el('a', { href: `#group-${name}` }, titleOf(name))))));
  return [list, ...names.flatMap((name) => group(name, titleOf(name), report.tables.filter((table) => table.source === name)))];
}
