// The trials of the results: the list, and the viewer that it opens.

import { inflated, readLines } from './blocks.js';
import { el } from './dom.js';
import { TrialList } from './trial_list.js';
import { TrialViewer } from './trial_viewer.js';

// The trial that the address names, or none; an address may hold anything.
function askedFor() {
  const asked = /^#trial=(.*)$/.exec(location.hash);
  try {
    return asked ? decodeURIComponent(asked[1]) : null;
  } catch {
    return null;
  }
}

export async function trials(report) {
  const [line] = readLines('trials');
  if (line === undefined) {
    return [el('p', {}, 'These results hold no trials.')];
  }
  const table = await inflated(line);
  const lines = { series: readLines('series'), worlds: readLines('worlds') };
  const withSeries = lines.series.length > 0;
  const viewer = withSeries ? new TrialViewer(report, lines) : null;
  const open = async (index) => {
    if (viewer === null) return;
    const name = table.rows[index][0];
    await viewer.open(index, name);
    list.mark(index);
    history.replaceState(null, '', `#trial=${encodeURIComponent(name)}`);
  };
  const list = new TrialList(table, open);
  const asked = askedFor();
  const index = asked === null ? -1 : table.rows.findIndex((row) => row[0] === asked);
  if (index >= 0) setTimeout(() => open(index));
  return [
    el('p', {}, withSeries
      ? 'The button with a trial’s name opens it below the list.'
      : 'The results hold no series, so a trial cannot be opened.'),
    list.element, viewer?.element,
  ];
}
