// How the numbers were made, and from what.

import { el } from './dom.js';
import { tableElement } from './tables.js';

export function methods(report) {
  const parts = report.methods.text.map((paragraph) => el('p', {}, paragraph));
  for (const { title, rows } of report.methods.settings) {
    parts.push(el('h3', {}, title), tableElement({
      columns: [
        { heading: 'Parameter', numeric: false }, { heading: 'Value', numeric: true },
        { heading: 'Unit', numeric: false }, { heading: 'Meaning', numeric: false },
      ],
      rows,
    }, title));
  }
  return parts;
}

const fileColumns = [
  { heading: 'File', numeric: false }, { heading: 'Files', numeric: true },
  { heading: 'Bytes', numeric: true }, { heading: 'SHA-256', numeric: false },
];

export function provenance(report) {
  return report.provenance.map((result) => el('section', { class: 'card' },
    el('h3', {}, `${result.name}: ${result.command}`),
    el('p', {}, `Written by ${result.tool}. ${result.seed === null ? 'No seed.' : `Seed ${result.seed}.`}`),
    el('details', {}, el('summary', {}, `Options (${result.options.length})`),
      tableElement({ columns: [{ heading: 'Option', numeric: false }, { heading: 'Value', numeric: false }],
        rows: result.options }, `Options of ${result.name}`)),
    result.inputs.length ? [el('h4', {}, 'Made from'), tableElement({ columns: fileColumns, rows: result.inputs }, `Inputs of ${result.name}`)] : null,
    el('h4', {}, 'Files'),
    tableElement({ columns: fileColumns, rows: result.outputs }, `Files of ${result.name}`)));
}
