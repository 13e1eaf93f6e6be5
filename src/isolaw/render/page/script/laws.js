// How a law is named.

import { element } from './dom.js';
import { colourOf, isAgain } from './plotting.js';
import { laws } from './report.js';
import { enumerate } from './text.js';

export function lawKey(law) {
  return element('span', { class: isAgain(law) ? 'key again' : 'key', style: `border-color: var(--${colourOf(law)})` });
}

// A law's name; where its prediction collapses, that stands beside it wherever it is recommended.
function collapseBadge() {
  return element(
    'span',
    { class: 'badge', title: 'misses the blocks it was not fitted to: see Prediction across the record' },
    'prediction collapses',
  );
}

export const lawName = (law) =>
  element(
    'span',
    {},
    element('b', { class: 'strong' }, law.id),
    ...(law.prediction_collapses ? [' ', collapseBadge()] : []),
  );

// A sentence in which the first mention of such a law has its badge.
export function withBadges(text) {
  const parts = [text];
  for (const law of laws.filter((one) => one.prediction_collapses)) {
    const name = new RegExp('(?<![\\w-])' + law.id.replace(/[^\w]/g, '\\$&') + '(?![\\w-])');
    const at = parts.findIndex((part) => typeof part === 'string' && name.test(part));
    if (at < 0) continue;
    const end = parts[at].search(name) + law.id.length;
    parts.splice(at, 1, parts[at].slice(0, end) + ' ', collapseBadge(), parts[at].slice(end));
  }
  return parts;
}

export function collapseNote(among) {
  const names = among.filter((law) => law.prediction_collapses).map((law) => law.id);
  return names.length > 0 ? ' Prediction across the record collapses: ' + enumerate(names) + '.' : '';
}
