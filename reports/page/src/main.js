import { inflated, readJson, readLines } from './blocks.js';
import { el } from './dom.js';
import { figures } from './figures.js';
import { frames } from './frames.js';
import { methods, provenance } from './methods.js';
import { summary } from './summary.js';
import { tables } from './tables.js';
import { trials } from './trials.js';

function header(report, sections) {
  document.getElementById('top').append(
    report.synthetic ? el('p', { class: 'banner', role: 'note' }, report.synthetic) : '',
    el('h1', {}, report.title),
    el('p', { class: 'lead' }, report.lead),
    el('nav', { 'aria-label': 'Sections' },
      el('ul', {}, sections.map(([id, title]) => el('li', {}, el('a', { href: `#${id}` }, title))))));
}

function section(id, title, content) {
  return el('section', { id, 'aria-labelledby': `${id}-title` }, el('h2', { id: `${id}-title` }, title), content);
}

function leftOut(report) {
  return el('ul', {}, report.left_out.map((words) => el('li', {}, words)));
}

function licences() {
  const text = el('pre', { class: 'scroll', tabindex: 0 });
  const details = el('details', {}, el('summary', {}, 'Licences of the scripts in this page'), text);
  details.addEventListener('toggle', async () => {
    if (text.textContent === '') text.textContent = await inflated(readLines('licences')[0]);
  });
  return details;
}

async function main() {
  const report = readJson('report');
  const drawn = figures(report);
  const parts = [
    ['summary', 'Summary', () => summary(report)],
    ['figures', 'Figures', () => drawn.content],
    ['trials-section', 'Trials', () => trials(report)],
    ...(report.frames.length ? [['frames-section', 'Frames', () => frames(report, readLines('frames'))]] : []),
    ['tables', 'Tables', () => tables(report)],
    ...(report.left_out.length ? [['left-out', 'Left out', () => leftOut(report)]] : []),
    ['provenance', 'Provenance', () => provenance(report)],
    ['methods', 'Methods', () => methods(report)],
  ];
  header(report, parts);
  const page = document.getElementById('main');
  for (const [id, title, content] of parts) page.append(section(id, title, await content()));
  document.getElementById('bottom').append(
    el('p', {}, `Written by ${report.tool}. This page carries everything it shows; it asks nothing of any network.`),
    licences());
  document.documentElement.dataset.ready = 'true';
  performance.mark('ready');
  // Once the reader has seen the page.
  requestAnimationFrame(() => setTimeout(drawn.start));
}

main().catch((error) => {
  document.getElementById('main').append(el('p', { class: 'notice', role: 'alert' }, `The page cannot be shown: ${error.message}`));
  throw error;
});
