// The two things that a reader may look at: the law to take, and the front of accuracy against robustness. The first
// screen's chart, list, headline and ranking follow the choice.

import { doesNotPredict, laws, lawsByObjective, report } from './report.js';
import { enumerate, fixed, isNumber, percentText, withUnit } from './text.js';
import { VIEWS, isPlaced } from './views.js';

const byId = new Map(laws.map((law) => [law.id, law]));

const { recommendation } = report.findings;

export const PURPOSES = [
  ...(recommendation
    ? [
        {
          id: 'answer',
          title: 'Which law to take',
          recommendation,
          answer: recommendation.answer,
          order: recommendation.standings.map(({ law }) => byId.get(law)),
        },
      ]
    : []),
  ...(VIEWS.length > 0 ? [{ id: 'robustness', title: 'Accuracy against robustness' }] : []),
];
export const TONES = { clear: 'good', tie: 'care', weak: 'care' };
export const FIRST = PURPOSES[0]?.id;

export const purposeOf = (id) => PURPOSES.find((purpose) => purpose.id === id);

export const standingsOf = (purpose) =>
  purpose.recommendation.standings.map((standing) => ({ ...standing, law: byId.get(standing.law) }));

export const errorText = (error) =>
  !isNumber(error) ? '\u2013' : error < 10 ? percentText(Number(error.toPrecision(2))) : '> 1000\u202f%';

const NAMED_AT_FIRST = 3;

// The laws that the page shows at first: up to three most accurate laws for the first purpose or, if no law can be
// recommended, the law with the least objective. A law that does not predict is left out.
export const recommended = (() => {
  const purpose = PURPOSES.find(({ id }) => id === FIRST);
  const named = purpose?.recommendation?.law
    ? standingsOf(purpose).filter(({ place }) => place === 'taken' || place === 'ties').map(({ law }) => law)
    : lawsByObjective.slice(0, 1);
  return named.filter((law) => !doesNotPredict(law)).slice(0, NAMED_AT_FIRST);
})();

export const viewOf = (id) => VIEWS.find((view) => view.id === id);

export function answering(purpose, viewId) {
  if (purpose.recommendation)
    return recommendation.law ? standingsOf(purpose).filter(({ place }) => place === 'taken' || place === 'ties').map(({ law }) => law) : [];
  const view = viewOf(viewId);
  return placedIn(view).filter((law) => view.onFront(law));
}

// Says which law to take for a purpose. A purpose without a recommendation gets the report's headline in the view of
// the runs, and in any other view the list of the laws on the front.
export function answerOf(purpose, viewId) {
  if (purpose.recommendation) return purpose.answer;
  const view = viewOf(viewId);
  if (view.id === 'runs') return report.findings.headline;
  return 'On the front ' + view.title + ': ' + enumerate(answering(purpose, viewId).map(({ name }) => name)) + '.';
}
export const placedIn = (view) => laws.filter((law) => isPlaced(view, law)).sort((a, b) => view.accurate(a) - view.accurate(b));

export function numbersOf(purpose, viewId) {
  if (purpose.id === 'robustness') {
    const view = viewOf(viewId);
    const worth = laws.filter(view.onFront).length;
    const least = (of) => laws.reduce((a, b) => (isNumber(of(b)) && (a === null || of(b) < of(a)) ? b : a), null);
    const [accurate, robust] = [least(view.accurate), least(view.robust)];
    return [
      [String(worth), (worth === 1 ? 'law' : 'laws') + ' on the front'],
      [fixed(view.accurate(accurate), 4), 'least OF, ' + accurate.name],
      [fixed(view.robust(robust), 3), 'least \u03b2, ' + robust.name],
    ];
  }
  const [first, second] = standingsOf(purpose);
  if (!recommendation.law)
    return [
      [String(laws.length), laws.length === 1 ? 'law tried' : 'laws tried'],
      [errorText(first?.error), 'least error, ' + first?.law.name],
      ['none', 'can be taken'],
    ];
  const fits = first.new_device === null ? [errorText(first.fits), 'fits'] : [errorText(first.new_device), 'new device'];
  const predicts = [errorText(first.predicts), 'larger swings'];
  const next = [second ? errorText(second.error) : '\u2013', second ? 'next, ' + second.law.name : 'no other law'];
  const parameters = [String(first.parameters), first.parameters === 1 ? 'parameter' : 'parameters'];
  return [fits, first.predicts === null ? next : predicts, parameters];
}
