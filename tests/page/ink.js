// What the layers of a figure leave on the page: each drawn alone and its pixels counted.

// In a page without a content policy. `svg` is the drawn figure, `spec` what it was drawn from. For each
// panel, layer and class: how many rows it draws, pixels of its colour, the columns with such a pixel and
// how far they reach.
export function inkOf({ svg, spec }) {
  const scale = 2;
  const root = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
  const panels = spec.concat ?? [spec];
  const rowsOf = (layer) => (layer.data?.values ?? spec.data.values).filter((row) =>
    layer.transform.every(({ filter }) => !filter || !('equal' in filter) || row[filter.field] === filter.equal)
    && ['x', 'y', 'x2', 'y2'].every((channel) => {
      const field = layer.encoding[channel]?.field;
      return !field || (row[field] !== null && row[field] !== undefined);
    }));

  async function pixels(prefix, i) {
    const copy = root.cloneNode(true);
    // Of the drawing alone: what is hidden clips everything away.
    copy.querySelectorAll(':scope > g').forEach((drawing) => drawing.setAttribute('style', 'visibility:hidden'));
    const marks = copy.querySelectorAll(`[class~="${prefix}layer_${i}_marks"]`);
    marks.forEach((mark) => mark.setAttribute('style', 'visibility:visible'));
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
    await image.decode();
    const canvas = new OffscreenCanvas(scale * image.width, scale * image.height);
    const context = canvas.getContext('2d');
    context.fillStyle = 'white';
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    return { data, width: canvas.width, marks: marks.length };
  }

  // A mixture of white and the colour; without a colour all that is not white.
  function counted({ data, width }, colour) {
    const wanted = colour && [1, 3, 5].map((at) => 255 - parseInt(colour.slice(at, at + 2), 16));
    const square = wanted?.reduce((sum, value) => sum + value * value, 0);
    const columns = new Set();
    const lines = new Set();
    let count = 0;
    for (let p = 0; p < data.length; p += 4) {
      const dark = [255 - data[p], 255 - data[p + 1], 255 - data[p + 2]];
      if (Math.max(...dark) < 16) continue;
      if (wanted) {
        const mixed = dark.reduce((sum, value, c) => sum + value * wanted[c], 0) / square;
        if (mixed < 0.1 || dark.some((value, c) => Math.abs(value - mixed * wanted[c]) > 24)) continue;
      }
      count += 1;
      columns.add((p / 4) % width);
      lines.add(Math.floor(p / 4 / width));
    }
    const reach = (set) => (set.size === 0 ? 0 : Math.max(...set) - Math.min(...set) + 1);
    return { count, columns: columns.size, across: reach(columns), up: reach(lines) };
  }

  return (async () => {
    const found = [];
    for (const [p, panel] of panels.entries()) {
      for (const [i, layer] of panel.layer.entries()) {
        if (!layer.transform) continue; // A line across the panel, at no row.
        const picture = await pixels(spec.concat ? `concat_${p}_` : '', i);
        const { color } = layer.encoding;
        const rows = rowsOf(layer);
        const classes = color?.scale?.domain ? color.scale.domain : [null];
        classes.forEach((name, c) => {
          if (color?.datum !== undefined && color.datum !== name) return;
          const own = name === null || color.datum !== undefined ? rows : rows.filter((row) => row[color.field] === name);
          found.push({
            layer: `panel ${p + 1}, layer ${i + 1}, ${layer.transform[0].filter.equal} ${name ?? ''}`,
            kind: layer.mark.type, guide: layer.mark.strokeDash !== undefined, rows: own.length, marks: picture.marks,
            ...counted(picture, name === null ? null : color.scale.range[c]),
          });
        });
      }
    }
    return found;
  })();
}
