import { element, strong } from '../dom.js';
import { lotQuantities } from '../lot.js';
import { report } from '../report.js';
import { said, tableOf } from '../tables.js';
import { THIN, count, significant, unitText } from '../text.js';

export const certificateBoundsFigure = {
  id: 'certificate-bounds',
  title: 'Lower and upper bound values',
  wanted: () => boundRows().length > 0,
  caption: boundsCaption,
  csv: () => ({
    columns: ['property', 'unit', 'design value', 'mean of the lot', 'lower bound', 'upper bound', 'of', 'from'],
    rows: boundRows().map((b) => [b.property, b.unit, b.nominal, b.mean, b.lower, b.upper, b.of, b.from]),
  }),
  build: boundsTable,
};

function boundRows() {
  const factors = report.assessment?.lot?.factors ?? [];
  const quantity = (name) => lotQuantities.find((q) => q.quantity === name);
  if (factors.length > 0)
    return factors.map((factor) => ({
      property: factor.property,
      unit: factor.unit,
      nominal: quantity(factor.property)?.nominal ?? null,
      mean: quantity(factor.property)?.mean ?? null,
      lower: factor.lower,
      upper: factor.upper,
      of: HELD_BY[factor.spread],
      from: [factor.source, factor.note, factor.no_lower_bound].filter(Boolean).join('; '),
    }));
  return lotQuantities
    .filter((q) => q.n > 1)
    .map((q) => ({
      property: q.quantity,
      unit: q.unit,
      nominal: q.nominal,
      mean: q.mean,
      lower: q.min,
      upper: q.max,
      of: 'the devices tested',
      from: 'smallest and largest',
    }));
}

const HELD_BY = { system: 'the isolation system', contract: 'by contract', device: 'one device' };

function boundsCaption() {
  if ((report.assessment?.lot?.factors?.length ?? 0) === 0)
    return 'No rule set gives modification factors, so the bounds are the smallest and the largest device tested. Other devices of the lot may lie beyond them.';
  const tested = report.assessment.lot.tested;
  return (
    'Design value, or mean where there is none, times the property modification factors. Bounds of one device contain 95' + THIN +
    '% of all devices with 95' + THIN + '% confidence, or the observed values; bounds of the system contain the mean of all devices of the lot.' +
    (tested < 5 ? ' Statistical bounds are wide, because the sample is small (' + count(tested, 'device') + ').' : '')
  );
}

function boundsTable() {
  const bounds = boundRows();
  const first = (i) => i === 0 || bounds[i - 1].property !== bounds[i].property;
  const columns = [
    { title: 'Property', pinned: true, cell: (b, i) => said(first(i), strong(b.property)) },
    { title: 'Unit', tight: true, cell: (b, i) => said(first(i), element('span', {}, unitText(b.unit))) },
    { title: 'Design value', number: true, cell: (b, i) => said(first(i), element('span', {}, significant(b.nominal, 4))) },
    { title: 'Mean of the lot', number: true, cell: (b, i) => said(first(i), element('span', {}, significant(b.mean, 4))) },
    { title: 'Lower bound', number: true, cell: (b) => significant(b.lower, 4) },
    { title: 'Upper bound', number: true, cell: (b) => significant(b.upper, 4) },
    { title: 'Bounds', tight: true, cell: (b) => b.of },
    { title: 'From', cell: (b) => element('td', { class: 'note text' }, b.from) },
  ];
  return tableOf(columns, bounds, 'Lower and upper bound values', { className: (_, i) => (first(i) ? 'group' : null) });
}
