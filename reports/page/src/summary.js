// The page's answer: what each result found, with the verdict as a word, the evidence and the rule; then
// the letters and short words that everything below uses.

import { el } from './dom.js';

const kinds = { supported: 'for', contradicted: 'against', 'not decided': 'open' };

// The colour repeats what the word says.
function verdict(word) {
  return word === null ? null : el('span', { class: `verdict ${kinds[word] ?? 'open'}` }, word);
}

function line({ about, verdict: word, evidence }, title) {
  // "H1, success, landmark panel" below the heading "H1".
  const name = about.startsWith(`${title}, `) ? about.slice(title.length + 2) : about;
  return el('li', {}, verdict(word), el('span', {}, el('strong', {}, name), el('span', { class: 'evidence' }, evidence)));
}

function list(lines, title) {
  return el('ul', { class: 'findings' }, lines.map((one) => line(one, title)));
}

// Conclusions are drawn from the landmark panel where there is one; the other panel waits behind a line.
function isAside({ about }, all) {
  return about.endsWith('paper panel') && all.some((other) => other.about.endsWith('landmark panel'));
}

function finding({ title, question, lines, rules }) {
  const aside = lines.filter((one) => isAside(one, lines));
  return el('section', { class: 'card finding' },
    el('h3', {}, question ? `${title}: ${question}` : title),
    list(lines.filter((one) => !aside.includes(one)), title),
    aside.length === 0 ? null : el('details', {},
      el('summary', {}, `The same in the paper panel (${aside.length})`), list(aside, title)),
    rules.map((rule) => el('p', { class: 'rule' }, rule)));
}

// Open where there is room beside the verdicts for it; a link above them leads to it.
function glossary(entries) {
  if (entries.length === 0) return [];
  const words = el('details', { class: 'glossary', id: 'words', open: matchMedia('(min-width: 700px)').matches },
    el('summary', {}, 'Letters and words on this page'),
    el('dl', {}, entries.map(([term, meaning]) => el('div', {}, el('dt', {}, term), el('dd', {}, meaning)))));
  const open = () => words.setAttribute('open', '');
  return [el('p', { class: 'lead' }, el('a', { href: '#words', onclick: open }, 'What the letters and words mean'), '.'), words];
}

export function summary(report) {
  const found = report.findings.length === 0
    ? el('p', {}, 'These results hold no findings: those of an older version have none, nor have results that only describe.')
    : el('div', { class: 'verdicts' }, report.findings.map(finding));
  const [link, words] = glossary(report.glossary);
  return [link, found, words];
}
