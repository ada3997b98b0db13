// What all scripts of the page use: elements, texts of times, results by their keys.

/** The first element that fits a selector. */
function find(selector, inside = document) {
  return inside.querySelector(selector);
}

/** An element of the page with attributes and children, texts among them. */
function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** The same in SVG. */
function draw(name, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** A length of time in nanoseconds with three decimals at most: `1.83 ms`. */
function timeText(ns) {
  const [size, unit] = ns >= 1e9 ? [1e9, 's'] : ns >= 1e6 ? [1e6, 'ms'] : ns >= 1e3 ? [1e3, 'µs'] : [1, 'ns'];
  return `${Number((ns / size).toFixed(3))} ${unit}`;
}

/** A copy of a result that stands in a table: its text with its key and its exact value. */
function copyOf(cell, name = 'span') {
  const attributes = {};
  for (const key of ['data-key', 'data-value']) {
    if (cell.hasAttribute(key)) attributes[key] = cell.getAttribute(key);
  }
  return make(name, attributes, cell.textContent);
}

/** The exact value of a cell; null where it holds none. */
function valueOf(cell) {
  return cell && cell.dataset.value ? JSON.parse(cell.dataset.value) : null;
}

const data = JSON.parse(find('#data').textContent);

/** What the reader has selected; whoever shows it is told of changes. */
const selection = {
  chain: null,  // {row, up: devices whose update() it takes, in order, down: the same of handle()}
  listeners: [],
  select(chain) {
    this.chain = chain;
    for (const listener of this.listeners) listener(chain);
  },
};

/** Light, dark, or as the system has it; remembered where the browser allows it to a file. */
function prepareTheme() {
  const button = find('#theme');
  const root = document.documentElement;
  const isDark = () => root.dataset.theme ? root.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  const say = () => {
    button.textContent = isDark() ? 'Light' : 'Dark';
    button.setAttribute('aria-label', `Change to ${isDark() ? 'light' : 'dark'} colours`);
  };
  const remember = (theme) => {
    try {
      localStorage.setItem('finemote-theme', theme);
    } catch { /* a file may not be allowed to */ }
  };
  try {
    const theme = localStorage.getItem('finemote-theme');
    if (theme === 'light' || theme === 'dark') root.dataset.theme = theme;
  } catch { /* the same */ }
  button.hidden = false;
  button.addEventListener('click', () => {
    root.dataset.theme = isDark() ? 'light' : 'dark';
    remember(root.dataset.theme);
    say();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', say);
  say();
}
