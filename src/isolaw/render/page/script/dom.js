import { typeset, unset } from './symbols.js';

// Inside these elements, which hold commands and file names, symbols are not typeset.
const LITERAL = new Set(['code', 'pre', 'a', 'kbd']);

const setIn = (tag) => (child) => (typeof child === 'string' && !LITERAL.has(tag) ? typeset(child) : [child]);

export function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value === true ? '' : unset(String(value)));
  }
  node.append(...children.filter((child) => child !== null && child !== undefined).flatMap(setIn(tag)));
  return node;
}

export const termList = (className, facts) =>
  element('dl', { class: className }, ...facts.flatMap(([term, text]) => [element('dt', {}, term), element('dd', {}, text)]));

export function shortList(items, most, few, className = null) {
  const shown = items.length <= most ? items.length : few;
  const list = (some) => element('ul', { class: className }, ...some);
  if (shown === items.length) return [list(items)];
  const rest = element('details', {}, element('summary', {}, items.length - shown + ' more'), list(items.slice(shown)));
  return [list(items.slice(0, shown)), rest];
}

export const isPrinting = () => 'printing' in document.documentElement.dataset;

// Returns no text when printing. For text about controls, columns and downloads, which a printed page lacks.
export const onScreen = (text) => (isPrinting() ? '' : text);
