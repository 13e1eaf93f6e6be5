import { elementsWith } from './element.js';
import { typeset, unset } from './symbols.js';

// In these elements, which hold commands and file names, symbols are not typeset.
const LITERAL = new Set(['code', 'pre', 'a', 'kbd']);

export const element = elementsWith((text, tag) => (LITERAL.has(tag) ? [text] : typeset(text)), unset);

export const strong = (text) => element('b', { class: 'strong' }, text);
export const button = (title, click, attributes = {}) => element('button', { type: 'button', click, ...attributes }, title);
export const sentences = (texts) => element('ul', { class: 'sentences' }, texts.map((text) => element('li', {}, text)));
export const empty = (text) => element('p', { class: 'empty' }, text);

export const termList = (className, facts) =>
  element('dl', { class: className }, facts.map(([term, text]) => [element('dt', {}, term), element('dd', {}, text)]));

export function shortList(items, most, few, className = null) {
  const shown = items.length <= most ? items.length : few;
  const list = (some) => element('ul', { class: className }, some);
  if (shown === items.length) return [list(items)];
  const rest = element('details', {}, element('summary', {}, items.length - shown + ' more'), list(items.slice(shown)));
  return [list(items.slice(0, shown)), rest];
}

export const isPrinting = () => 'printing' in document.documentElement.dataset;

// Returns an empty text when printing, since a printed page has no controls or downloads that the text could explain.
export const onScreen = (text) => (isPrinting() ? '' : text);

// Returns a command line with a button that copies it.
export function commandLine(command) {
  const code = element('code', { class: 'command', tabindex: '0' }, command);
  const copy = ({ currentTarget: pressed }) => {
    getSelection().selectAllChildren(code);
    // Browsers copy only on secure pages. On other pages the command stays selected for Ctrl-C.
    navigator.clipboard?.writeText(command).then(() => (pressed.textContent = 'Copied'), () => {});
  };
  return element('div', { class: 'command-line' }, code, button('Copy', copy, { class: 'action screen' }));
}
