import { element } from '../dom.js';
import { report } from '../report.js';

// Returns the letterhead of the laboratory as a picture, or as lines of text without typeset symbols. Returns null if
// the user gave no file for it.
export function letterhead() {
  const { letterhead: given } = report;
  if (!given) return null;
  if (given.startsWith('data:image/')) return element('p', { class: 'letterhead' }, element('img', { src: given, alt: 'Letterhead of the laboratory' }));
  return element('p', { class: 'letterhead' }, document.createTextNode(given));
}
