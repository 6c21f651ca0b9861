// CSV as the tool writes it (RFC 4180, comma): rows of cells, all text. A first line with '#' is a label.

export function csvParseRows(text) {
  const rows = [];
  let row = [];
  let cell = '';
  let quoted = false;
  let start = 0;
  while (text[start] === '#') start = text.indexOf('\n', start) + 1;
  for (let i = start; i < text.length; ++i) {
    const c = text[i];
    if (quoted) {
      if (c !== '"') cell += c;
      else if (text[i + 1] === '"') cell += text[++i];
      else quoted = false;
    } else if (c === '"') {
      quoted = true;
    } else if (c === ',') {
      row.push(cell);
      cell = '';
    } else if (c === '\n') {
      row.push(cell);
      rows.push(row);
      row = [];
      cell = '';
    } else {
      cell += c;
    }
  }
  return rows;
}
