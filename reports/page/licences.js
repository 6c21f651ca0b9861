// The licence of every package that esbuild's metafile names, as one text: licences.js META > licences.txt

import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

const inputs = Object.keys(JSON.parse(readFileSync(process.argv[2], 'utf8')).inputs);
const folders = new Set(inputs.map((input) => /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(input)?.[1]).filter(Boolean));
const texts = new Map();
for (const folder of [...folders].sort()) {
  const { name, version, license, author } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  const owner = typeof author === 'string' ? author : author?.name;
  const text = file && existsSync(join(folder, file)) ? readFileSync(join(folder, file), 'utf8').replace(/\r/g, '').trim()
    : `${license}${owner ? `, ${owner}` : ''}`;
  texts.set(text, [...(texts.get(text) ?? []), `${name} ${version}`]);
}
for (const [text, packages] of texts) process.stdout.write(`${packages.join(', ')}\n\n${text}\n\n\n`);
