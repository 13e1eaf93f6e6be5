import { element } from '../dom.js';

// Makes a line that is filled in on the page or on paper. The page does not save the entry.
export const blank = (label, more = {}) =>
  element('span', { class: 'blank', contenteditable: 'plaintext-only', role: 'textbox', spellcheck: 'false', 'aria-label': label, ...more });

// Holds the lines made by echoed(). They are like those of blank(), but echo() repeats on other pages of the
// certificate what is typed into them.
const lines = new Map(); // label -> {line, echoes}
export function echoed(label) {
  const echoes = [];
  const line = blank(label, { input: () => echoes.forEach((node) => (node.textContent = line.textContent)) });
  lines.set(label, { line, echoes });
  return line;
}

// Returns nodes that repeat the line of echoed(): its label and what was typed into it. A line that is still empty may
// also be filled in on paper. Returns no nodes if there is no line with this label.
export function echo(label) {
  if (!lines.has(label)) return [];
  const { line, echoes } = lines.get(label);
  const node = element('span', { class: 'echo' });
  node.textContent = line.textContent;
  echoes.push(node);
  return [label + '\u00a0', node, ' '];
}
