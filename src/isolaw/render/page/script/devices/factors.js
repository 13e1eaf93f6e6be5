import { element } from '../dom.js';
import { lotQuantities } from '../lot.js';
import { report } from '../report.js';
import { table } from '../tables.js';
import { DASH, fixed, isNumber, significant, unitText } from '../text.js';

export const factorsFigure = {
  id: 'factors',
  title: 'Property modification factors',
  long: true,
  wanted: () => (report.assessment?.lot?.factors.length ?? 0) > 0,
  caption: factorCaption,
  csv: factorData,
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
    'Factors on the design value (on the mean of the lot where there is none) and the bounds they give. The spread of single devices bounds a device; only the spread of the system may bound the whole isolation system.' +
    (history.length > 0
      ? ' Each holds that of the test, smallest and largest counted cycle over the mean of the first three: ' +
        history.join(', ') + '.'
      : '')
  );
}

function factorTable() {
  const columns = [
    { title: 'Property', pinned: true },
    { title: 'Source', tight: true },
    { title: 'Spread of', tight: true },
    { title: '\u03bb min', number: true },
    { title: '\u03bb max', number: true },
    { title: 'Lower bound', number: true },
    { title: 'Upper bound', number: true },
    { title: 'Unit', tight: true },
    { title: 'Note' },
  ];
  const { factors } = report.assessment.lot;
  const spreadOf = (source) =>
    source.startsWith('statistical, system') ? 'the system' : source === 'contract band' ? DASH : 'one device';
  const rows = factors.map((factor, i) => {
    const first = i === 0 || factors[i - 1].property !== factor.property;
    return {
      className: first ? 'group' : null,
      cells: [
        element('b', { class: 'strong' }, first ? factor.property : ''),
        factor.source,
        spreadOf(factor.source),
        fixed(factor.lambda_min, 3),
        fixed(factor.lambda_max, 3),
        significant(factor.lower, 4),
        significant(factor.upper, 4),
        unitText(factor.unit),
        element('td', { class: 'note text' }, [factor.note, factor.no_lower_bound].filter(Boolean).join('; ')),
      ],
    };
  });
  return table(columns, rows, 'Property modification factors');
}

function factorData() {
  const keys = [
    'property', 'source', 'spec_min', 'spec_max', 'lambda_min', 'lambda_max', 'lower', 'upper', 'unit', 'note',
    'no_lower_bound',
  ];
  return { columns: keys, rows: report.assessment.lot.factors.map((factor) => keys.map((key) => factor[key])) };
}
