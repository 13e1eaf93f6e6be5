import { chosen } from '../choice.js';
import { element, sentences, shortList } from '../dom.js';
import { marker, roleTone } from '../icons.js';
import { isInadequate, lawName, lawOf, withBadges } from '../laws.js';
import { TONES, errorText, placedIn, purposeOf, standingsOf, viewOf } from '../purposes.js';
import { laws, report } from '../report.js';
import { fixed, sentence } from '../text.js';

export const convergedFigure = {
  id: 'converged',
  width: 'wide',
  title: 'Without the optimiser\u2019s noise, and for an untested device',
  wanted: () => report.findings.converged.length > 0,
  build: () =>
    sentences(
      report.findings.converged.map(({ kind, sentence: text, other_laws: others }) =>
        withBadges(sentence(text), kind === 'converged-front' ? others.map(lawOf) : []),
      ),
    ),
};

export const verdictsFigure = { id: 'verdicts', width: 'narrow', title: '', depends: ['purpose', 'view'], build: verdictList };

const ROLES = { taken: 'most accurate', ties: 'most accurate', behind: 'not ranked', 'ruled out': 'not adequate' };

// The text after a law's error: the reason for the law's place or, without a reason, the place itself unless it is
// 'behind'. If the reason is poor prediction, the text is empty, because the badge beside the law's name states this.
const said = (place, reason, kind) =>
  reason ? (kind === 'out-prediction' ? '' : ', ' + sentence(reason)) : place === 'behind' ? '' : ', ' + place;

function verdictList() {
  const purpose = purposeOf(chosen.purpose);
  const items = purpose.recommendation
    ? standingsOf(purpose).map(({ law, place, error, reason, reason_kind: kind }) => {
        const asGood = place === 'taken' || place === 'ties'; // these have the tone of the answer, as in the chart
        return element(
          'li',
          { class: asGood ? null : 'brief' },
          marker(ROLES[place], asGood ? TONES[purpose.recommendation.sure] : undefined),
          element('div', {}, lawName(law), ' ' + errorText(error) + said(place, reason, kind)),
        );
      })
    : chosen.view === 'runs'
      ? rankedList()
      : frontList(viewOf(chosen.view));
  return element('div', {}, element('ul', { class: 'verdicts' }, ...items), cares());
}

function frontList(view) {
  return placedIn(view).map((law) => {
    const role = isInadequate(law) ? 'not adequate' : view.onFront(law) ? 'on the front' : 'dominated';
    const numbers = ' OF ' + fixed(view.accurate(law), 4) + ', ' + fixed(view.robust(law), 3) + ', ' + role;
    return element('li', { class: view.onFront(law) ? null : 'brief' }, marker(role), element('div', {}, lawName(law), numbers));
  });
}

function rankedList() {
  return report.findings.verdicts.map((verdict) => {
    const law = laws[verdict.law];
    const tone = roleTone(verdict.role);
    const inOneLine = tone === 'poor' || tone === 'muted';
    const role = inOneLine ? ' ' : element('span', { class: 'role ' + tone }, verdict.role);
    return element(
      'li',
      { class: inOneLine ? 'brief' : null },
      marker(verdict.role),
      element('div', {}, lawName(law), role, inOneLine ? null : element('br'), sentence(verdict.sentence)),
    );
  });
}

function cares() {
  const { warnings } = report.findings;
  if (warnings.length === 0)
    return element('p', { class: 'calm' }, 'Nothing stands out: no device was refused, no run failed, no parameter lies at its bound.');
  const actions = [...new Set(warnings.map(({ action }) => action))];
  return element(
    'div',
    { class: 'warnings' },
    ...actions.map((action) => {
      const some = warnings.filter((warning) => warning.action === action);
      return element(
        'details',
        {},
        element('summary', {}, action + ' (' + some.length + ')'),
        element('ul', {}, ...some.map((warning) => element('li', {}, warning.sentence))),
      );
    }),
  );
}

export function takeCare() {
  const warnings = report.findings.warnings.map((warning) => element('li', {}, warning.sentence));
  return element('div', { class: 'warnings' }, element('h3', {}, 'Take care'), ...shortList(warnings, 5, 4));
}
