import { element, shortList } from '../dom.js';
import { report } from '../report.js';
import { capitalised, sentence } from '../text.js';
import { WORDS, verdictBadge, wordOf } from '../verdicts.js';

// Shows the overall verdict. Its sentence names the requirements that were not assessed, and the list below names those
// that failed and those that passed.
export const verdictFigure = { id: 'verdict', title: '', build: band };

function band() {
  const { word, sentence: said, requirements, failing, not_assessed: without } = report.result;
  const remark = ({ device, remark: what }) => element('li', {}, element('b', {}, device ?? 'The lot'), ' ' + sentence(what));
  // The sentence names up to ten failing devices. If more fail, the remarks name all of them. The remarks also name the
  // devices without an assessment.
  const rest = [...(failing.length > 10 ? failing : []), ...without];
  return element(
    'div',
    { class: 'band ' + (word ? WORDS[word].tone : 'muted') },
    word ? element('p', { class: 'word' }, wordOf(report.result)) : null,
    element('p', { class: 'said' }, sentence(capitalised(said)) + '.'),
    element(
      'ul',
      { class: 'requirements' },
      ...['fail', 'pass'].map((verdict) => {
        const names = requirements.filter((one) => one.verdict === verdict).map(({ name }) => name);
        return names.length > 0 ? element('li', {}, verdictBadge(verdict), ' ' + names.join(', ')) : null;
      }),
    ),
    rest.length > 0 ? element('div', { class: 'remarks' }, ...shortList(rest.map(remark), 5, 4)) : null,
  );
}
