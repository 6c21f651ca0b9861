// The blocks of data that the page carries: JSON as it is, or one deflated, base64-coded piece a line.

function textOf(id) {
  return document.getElementById(id).textContent;
}

export function readJson(id) {
  return JSON.parse(textOf(id));
}

export function readLines(id) {
  return textOf(id).split('\n').filter((line) => line !== '');
}

export async function inflated(line) {
  const binary = atob(line);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return JSON.parse(await new Response(stream).text());
}

// Whole numbers as differences to the one before, in units of 1/scale; null where missing.
export function decoded({ scale, steps }) {
  let sum = 0;
  return steps.map((step) => {
    if (step === null) return null;
    sum += step;
    return sum / scale;
  });
}
