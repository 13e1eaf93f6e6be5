import { chosen } from '../choice.js';
import { element, sentences } from '../dom.js';
import { marker, roleTone } from '../icons.js';
import { isInadequate, lawName, lawOf, withBadges } from '../laws.js';
import { laws, report } from '../report.js';
import { enumerate, fixed, sentence } from '../text.js';
import { VIEWS, isPlaced } from '../views.js';

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

export const verdictsFigure = { id: 'verdicts', width: 'narrow', title: '', wanted: () => VIEWS.length > 0, depends: ['view'], build: verdictList };

// Lists the laws. In the view of the runs, the list says the verdict on each law. In the other views it says the two
// numbers that the plot shows for each law.
function verdictList() {
  const view = VIEWS.find(({ id }) => id === chosen.view);
  const runs = view.id === 'runs';
  const standing = placedIn(view).filter((law) => view.onFront(law));
  const headline = runs ? report.findings.headline : 'On the front ' + view.title + ': ' + enumerate(standing.map(({ name }) => name)) + '.';
  return element(
    'div',
    {},
    element('p', { class: 'explanation' }, ...withBadges(sentence(headline), standing)),
    element('ul', { class: 'verdicts' }, ...(runs ? rankedList() : frontList(view))),
  );
}

const placedIn = (view) => laws.filter((law) => isPlaced(view, law)).sort((a, b) => view.accurate(a) - view.accurate(b));

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
