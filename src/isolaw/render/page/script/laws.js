// How a law is named.

import { element } from './dom.js';
import { colourOf, isAgain } from './plotting.js';
import { laws } from './report.js';
import { enumerate } from './text.js';

export function lawKey(law) {
  return element('span', { class: isAgain(law) ? 'key again' : 'key', style: `border-color: var(--${colourOf(law)})` });
}

const doesNotPredict = (law) => law.prediction_grade === 'poor' || law.prediction_grade === 'unusable';

// A law's name; where it does not predict, that stands beside it wherever it is recommended.
function predictionBadge(law) {
  return element(
    'span',
    { class: 'badge', title: 'misses the blocks it was not fitted to: see Prediction across the record' },
    law.prediction_collapses ? 'prediction collapses' : 'prediction poor',
  );
}

export const lawName = (law) =>
  element(
    'span',
    {},
    element('b', { class: 'strong' }, law.id),
    ...(doesNotPredict(law) ? [' ', predictionBadge(law)] : []),
  );

// A sentence in which the first mention of such a law has its badge.
export function withBadges(text) {
  const parts = [text];
  for (const law of laws.filter(doesNotPredict)) {
    const name = new RegExp('(?<![\\w-])' + law.id.replace(/[^\w]/g, '\\$&') + '(?![\\w-])');
    const at = parts.findIndex((part) => typeof part === 'string' && name.test(part));
    if (at < 0) continue;
    const end = parts[at].search(name) + law.id.length;
    parts.splice(at, 1, parts[at].slice(0, end) + ' ', predictionBadge(law), parts[at].slice(end));
  }
  return parts;
}

export function collapseNote(among) {
  const names = among.filter((law) => law.prediction_collapses).map((law) => law.id);
  return names.length > 0 ? ' Prediction across the record collapses: ' + enumerate(names) + '.' : '';
}
