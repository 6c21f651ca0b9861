// Elements made from data. Text always goes in as text: nothing here parses HTML.

const svgNamespace = 'http://www.w3.org/2000/svg';

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else node.setAttribute(name, value === true ? '' : String(value));
  }
  for (const child of children.flat()) {
    if (child !== null && child !== undefined) node.append(child);
  }
  return node;
}

export function el(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

export function svg(tag, attributes = {}, ...children) {
  return fill(document.createElementNS(svgNamespace, tag), attributes, children);
}

// A button that hands `text()` over as a file; nothing leaves the page.
export function saveButton(label, file, type, text) {
  const save = () => {
    const url = URL.createObjectURL(new Blob([text()], { type }));
    const link = el('a', { href: url, download: file });
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  };
  return el('button', { type: 'button', class: 'small', onclick: save }, label);
}

// A value of the page's style, for drawings that need it as a word.
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

// Calls `repaint` when the reader's system turns from light to dark or back.
export function onThemeChange(repaint) {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', repaint);
}
