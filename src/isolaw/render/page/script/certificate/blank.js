import { element } from '../dom.js';

// Makes a line that is filled in on the page or on paper. The page does not save the entry.
export const blank = (label, more = {}) =>
  element('span', { class: 'blank', contenteditable: 'plaintext-only', role: 'textbox', spellcheck: 'false', 'aria-label': label, ...more });
