import { element } from '../dom.js';
import { report } from '../report.js';

// The laboratory's letterhead as a picture or as lines of text, in which no symbols are typeset. Null without a file.
export function letterhead() {
  const { letterhead: given } = report;
  if (!given) return null;
  if (given.startsWith('data:image/')) return element('p', { class: 'letterhead' }, element('img', { src: given, alt: 'Letterhead of the laboratory' }));
  return element('p', { class: 'letterhead' }, document.createTextNode(given));
}
