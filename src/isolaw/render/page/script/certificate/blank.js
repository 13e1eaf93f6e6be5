import { element } from '../dom.js';

// A line to write on, here or on paper. It is kept nowhere but on the page.
export function blank(label, text = '') {
  return element(
    'span',
    { class: 'blank', contenteditable: 'plaintext-only', role: 'textbox', spellcheck: 'false', 'aria-label': label },
    text,
  );
}
