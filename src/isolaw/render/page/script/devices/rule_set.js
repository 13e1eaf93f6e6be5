import { element, termList } from '../dom.js';
import { designText, sampleText } from '../lot.js';
import { report } from '../report.js';
import { sentence } from '../text.js';

export const ruleSetFigure = {
  id: 'rule-set',
  title: 'Rule set and design values',
  wanted: () => report.assessment !== null,
  build: ruleSetStatement,
};

function ruleSetStatement() {
  const { rule_set: rules, lot } = report.assessment;
  const facts = [
    [
      'Rule set',
      rules ? rules.title + (rules.edition ? ', ' + rules.edition : '') : 'none chosen: values only, no limits',
    ],
    ...(rules?.source ? [['Source', rules.source]] : []),
    ...(rules ? [['Verified by', rules.verified_by || 'nobody']] : []),
    ['Design values', designText() || 'none given, so no deviations'],
    ...(rules && lot?.sample ? [['Sample', sampleText(lot.sample)]] : []),
    ...(lot?.note ? [['The lot', lot.note]] : []),
    ...(lot?.mean_analysis?.sentence ? [['Mean properties', lot.mean_analysis.sentence]] : []),
  ];
  const unverified = rules !== null && !rules.verified_by;
  return element(
    'div',
    {},
    unverified
      ? element(
          'p',
          { class: 'warnings' },
          element('b', {}, 'The limits of this set are not verified: deviations are given without a verdict.'),
        )
      : null,
    termList('facts-list', facts.map(([term, text]) => [term, sentence(text)])),
  );
}
