import { element, strong } from '../dom.js';
import { lotQuantities } from '../lot.js';
import { report, resultData } from '../report.js';
import { said, tableOf } from '../tables.js';
import { DASH, fixed, isNumber, significant, unitText } from '../text.js';

export const factorsFigure = {
  id: 'factors',
  title: 'Property modification factors',
  long: true,
  wanted: () => (report.assessment?.lot?.factors.length ?? 0) > 0,
  caption: factorCaption,
  csv: () => resultData('factors', report.assessment.lot.factors.map((factor) => [factor])),
  build: factorTable,
};

function factorCaption() {
  const history = lotQuantities
    .filter((q) => isNumber(q.lambda_test_min))
    .map(
      (q) =>
        q.quantity + ' ' + fixed(q.lambda_test_min, 3) + ' (cycle ' +
        q.lambda_test_min_cycle + ') to ' + fixed(q.lambda_test_max, 3) + ' (cycle ' + q.lambda_test_max_cycle + ')',
    );
  return (
    'Factors on the design value (on the mean of the lot where there is none) and the bounds that result. The spread of single devices gives bounds for one device; only the spread of the system may give bounds for the whole isolation system.' +
    (history.length > 0
      ? ' Each includes the factor of the test: smallest and largest counted cycle, divided by the mean of the first three: ' +
        history.join(', ') + '.'
      : '')
  );
}

function factorTable() {
  const { factors } = report.assessment.lot;
  const first = (i) => i === 0 || factors[i - 1].property !== factors[i].property;
  const spreads = { system: 'the system', contract: DASH, device: 'one device' };
  const note = (factor) =>
    element('td', { class: 'note text' }, [factor.note, factor.no_lower_bound].filter(Boolean).join('; '));
  const columns = [
    { title: 'Property', pinned: true, cell: (factor, i) => said(first(i), strong(factor.property)) },
    { title: 'Source', tight: true, cell: (factor) => factor.source },
    { title: 'Spread of', tight: true, cell: ({ spread }) => spreads[spread] },
    { title: '\u03bb min', number: true, cell: (factor) => fixed(factor.lambda_min, 3) },
    { title: '\u03bb max', number: true, cell: (factor) => fixed(factor.lambda_max, 3) },
    { title: 'Lower bound', number: true, cell: (factor) => significant(factor.lower, 4) },
    { title: 'Upper bound', number: true, cell: (factor) => significant(factor.upper, 4) },
    { title: 'Unit', tight: true, cell: (factor) => unitText(factor.unit) },
    { title: 'Note', cell: note },
  ];
  return tableOf(columns, factors, 'Property modification factors', { className: (_, i) => (first(i) ? 'group' : null) });
}
