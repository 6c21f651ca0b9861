// Results for the page to show, made by the tool itself, and their files as they are on disk.

import { execFileSync, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const tcert = process.env.TCERT;

export function run(...words) {
  return execFileSync(tcert, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

export function attempt(...words) {
  const done = spawnSync(tcert, words, { encoding: 'utf8' });
  return { code: done.status, words: done.stderr };
}

// Every command's results of the synthetic corpus, made by this build.
export function study(folder) {
  run('reproduce', '--quiet', '--output', folder);
}

// A few trials of the study's corpus, of an algorithm with a name that tries to be code.
export const hostile = '</script><script>window.hacked=1</script><img src=x onerror="window.hacked=1">';

export function smallStudy(corpus, folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const bundle = join(folder, 'logs');
  mkdirSync(bundle);
  const ids = ['t0000000', 't0000001', 't0000002', 't0000003'];
  for (const id of ids) {
    cpSync(join(corpus, 'logs', id), join(bundle, 'logs', id), { recursive: true });
  }
  cpSync(join(corpus, 'bundle.json'), join(bundle, 'bundle.json'));
  const [header, ...rows] = csv(readFileSync(join(corpus, 'trials.csv'), 'utf8'));
  const quoted = (cell) => `"${cell.replaceAll('"', '""')}"`;
  const lines = rows.filter((row) => ids.includes(row[header.indexOf('trial_id')])).map((row) =>
    row.map((cell, c) => quoted(header[c] === 'algorithm' ? hostile : cell)).join(','));
  writeFileSync(join(bundle, 'trials.csv'), `${header.join(',')}\n${lines.join('\n')}\n`);
  run('certify', bundle, '--witness', '--quiet', '--output', join(folder, 'results'));
  return { bundle, results: join(folder, 'results') };
}

// The result as a version made it that wrote no findings.
export function withoutFindings(result) {
  for (const name of filesOf(result, '')) if (name.startsWith('findings.')) rmSync(join(result, name));
  const path = join(result, 'manifest.json');
  const manifest = JSON.parse(readFileSync(path, 'utf8'));
  manifest.outputs = manifest.outputs.filter((output) => !output.path.startsWith('findings.'));
  writeFileSync(path, `${JSON.stringify(manifest, null, 2)}\n`);
}

// Gives a result step-by-step pictures, listed in its manifest like everything else in it.
export function addFrames(result, count) {
  const folder = join(result, 'frames');
  mkdirSync(folder, { recursive: true });
  let bytes = 0;
  let lines = '';
  for (let i = 0; i < count; ++i) {
    const name = `step_${String(i).padStart(3, '0')}.svg`;
    const text = `<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100"><circle cx="${10 + 40 * i}" cy="50" r="9"/></svg>`;
    writeFileSync(join(folder, name), text);
    bytes += text.length;
    lines += `${createHash('sha256').update(text).digest('hex')}  ${name}\n`;
  }
  const path = join(result, 'manifest.json');
  const manifest = JSON.parse(readFileSync(path, 'utf8'));
  manifest.outputs.push({ path: 'frames/', files: count, bytes, sha256: createHash('sha256').update(lines).digest('hex') });
  manifest.outputs.sort((a, b) => (a.path < b.path ? -1 : 1));
  writeFileSync(path, `${JSON.stringify(manifest, null, 2)}\n`);
}

export function csv(text) {
  const rows = [];
  for (const line of text.split('\n')) {
    if (line === '' || line.startsWith('#')) continue;
    const cells = [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(,|$)/g)].slice(0, -1).map((match) =>
      match[1].startsWith('"') ? match[1].slice(1, -1).replaceAll('""', '"') : match[1]);
    if (line.endsWith(',')) cells.push('');
    rows.push(cells);
  }
  return rows;
}

// Rows of a CSV file as objects.
export function records(path) {
  const [header, ...rows] = csv(readFileSync(path, 'utf8'));
  return rows.map((row) => Object.fromEntries(header.map((name, c) => [name, row[c] ?? ''])));
}

export function filesOf(folder, ending) {
  return readdirSync(folder).filter((name) => name.endsWith(ending)).sort();
}
