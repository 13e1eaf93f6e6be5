// What the reader wants a law for: what the first screen shows, chart, list, headline and ranking, follows it.

import { laws, report } from './report.js';
import { enumerate, fixed, isNumber, percentText } from './text.js';
import { VIEWS, isPlaced } from './views.js';

const byId = new Map(laws.map((law) => [law.id, law]));

// The recommendations, and beside them the paper's question: accuracy against robustness.
export const PURPOSES = [
  ...report.findings.recommendations.map((recommendation) => ({
    id: recommendation.purpose,
    title: recommendation.title,
    recommendation,
    answer: recommendation.answer,
    order: recommendation.standings.map(({ law }) => byId.get(law)),
  })),
  ...(VIEWS.length > 0 ? [{ id: 'robustness', title: 'Accuracy against robustness' }] : []),
];

// The first that has an answer.
export const FIRST = (PURPOSES.find(({ recommendation }) => recommendation?.law) ?? PURPOSES[0])?.id;

export const purposeOf = (id) => PURPOSES.find((purpose) => purpose.id === id);

export const standingsOf = (purpose) =>
  purpose.recommendation.standings.map((standing) => ({ ...standing, law: byId.get(standing.law) }));

export const errorText = (error) =>
  !isNumber(error) ? '\u2013' : error < 10 ? percentText(Number(error.toPrecision(2))) : '> 1000\u202f%';

export const viewOf = (id) => VIEWS.find((view) => view.id === id);

// The answer in a sentence; of robustness that of the view: as the paper has it, or who is on the front there.
export function answerOf(purpose, viewId) {
  if (purpose.recommendation) return purpose.answer;
  const view = viewOf(viewId);
  if (view.id === 'published') return report.findings.headline;
  const front = placedIn(view).filter((law) => view.onFront(law));
  return 'On the front ' + view.title + ': ' + enumerate(front.map(({ id }) => id)) + '.';
}

// The laws of a view, from accurate to not.
export const placedIn = (view) => laws.filter((law) => isPlaced(view, law)).sort((a, b) => view.accurate(a) - view.accurate(b));

// Three numbers that carry the answer, each with what it is.
export function numbersOf(purpose, viewId) {
  if (purpose.id === 'robustness') {
    const view = viewOf(viewId);
    const worth = laws.filter(view.onFront).length;
    const least = (of) => laws.reduce((a, b) => (isNumber(of(b)) && (a === null || of(b) < of(a)) ? b : a), null);
    const [accurate, robust] = [least(view.accurate), least(view.robust)];
    return [
      [String(worth), (worth === 1 ? 'law' : 'laws') + ' on the front'],
      [fixed(view.accurate(accurate), 4), 'least OF, ' + accurate.id],
      [fixed(view.robust(robust), 3), 'least \u03b2, ' + robust.id],
    ];
  }
  const { recommendation } = purpose;
  const [first, second] = standingsOf(purpose);
  if (!recommendation.law)
    return [
      [String(laws.length), laws.length === 1 ? 'law tried' : 'laws tried'],
      [errorText(first?.error), 'least error, ' + first?.law.id],
      ['none', 'can be taken'],
    ];
  const free = first.law.parameters.filter((parameter) => parameter.free).length;
  return [
    [errorText(recommendation.error), 'its error'],
    [second ? errorText(second.error) : '\u2013', second ? 'next, ' + second.law.id : 'no other law'],
    [String(free), free === 1 ? 'parameter' : 'parameters'],
  ];
}
