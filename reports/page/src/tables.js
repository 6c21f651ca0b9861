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
    el('h4', {}, table.title + n),
    tableElement(table, table.title),
    table.footnotes.length
      ? el('ul', { class: 'footnotes' }, table.footnotes.map((note) => el('li', {}, note))) : null,
    el('p', { class: 'actions' },
      saveButton('Save as CSV', `${table.name}.csv`, 'text/csv', () => table.csv)));
}

// The tables of one folder of results: those to read first, then the others behind a line.
function group(name, all) {
  const main = all.filter((table) => table.main);
  const further = all.filter((table) => !table.main);
  return [
    el('h3', { class: 'group', id: `group-${name}` }, name),
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
  const list = names.length < 2 ? null
    : el('nav', { 'aria-label': 'Tables by result', class: 'contents' }, el('ul', {}, names.map((name) =>
        el('li', {}, el('a', { href: `#group-${name}` }, name)))));
  return [list, ...names.flatMap((name) => group(name, report.tables.filter((table) => table.source === name)))];
}
