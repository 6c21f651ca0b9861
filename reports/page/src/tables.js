// Tables as tables: cells come printed, the same digits as in text and LaTeX.

import { el, saveButton } from './dom.js';

function heading(column) {
  const unit = column.unit ? ` [${column.unit}]` : '';
  return el('th', { scope: 'col', class: column.numeric ? 'number' : null }, column.heading + unit);
}

function row(table, cells) {
  return el('tr', {}, cells.map((text, c) => {
    const missing = text === 'NA' ? ' missing' : '';
    const kind = (table.columns[c].numeric ? 'number' : '') + missing;
    return el(c === 0 ? 'th' : 'td', { scope: c === 0 ? 'row' : null, class: kind || null }, text);
  }));
}

export function tableElement(table, caption) {
  return el('div', { class: 'scroll', role: 'region', tabindex: 0, 'aria-label': caption },
    el('table', {},
      el('caption', { class: 'unseen' }, caption),
      el('thead', {}, el('tr', {}, table.columns.map(heading))),
      el('tbody', {}, table.rows.map((cells) => row(table, cells)))));
}

function tableSection(table) {
  const n = table.n === null ? '' : ` (n = ${table.n})`;
  return el('section', { class: 'card', id: `table-${table.id}` },
    el('h3', {}, table.title + n),
    table.source ? el('p', { class: 'source' }, table.source) : null,
    tableElement(table, table.title),
    table.footnotes.length
      ? el('ul', { class: 'footnotes' }, table.footnotes.map((note) => el('li', {}, note))) : null,
    el('p', { class: 'actions' },
      saveButton('Save as CSV', `${table.name}.csv`, 'text/csv', () => table.csv)));
}

export function tables(report) {
  if (report.tables.length === 0) {
    return [el('p', {}, 'These results hold no table.')];
  }
  const list = report.tables.length < 4 ? null
    : el('nav', { 'aria-label': 'Tables', class: 'contents' }, el('ul', {}, report.tables.map((table) =>
        el('li', {}, el('a', { href: `#table-${table.id}` }, table.title)))));
  return [list, ...report.tables.map(tableSection)];
}
