import { element, strong } from '../dom.js';
import { lotQuantities } from '../lot.js';
import { devices, report, resultColumns } from '../report.js';
import { tableOf } from '../tables.js';
import {
  DASH, count, deviation, enumerate, fixed, isNumber, limitText, short, significant, unitText,
} from '../text.js';
import { verdictBadge } from '../verdicts.js';

export const lotFigure = {
  id: 'lot',
  title: 'The lot, property by property',
  long: true,
  wanted: () => lotQuantities.length > 0,
  caption: lotCaption,
  csv: lotData,
  build: lotTable,
};

function lotCaption() {
  const { lot } = report.assessment;
  const failing = devices.filter((device) => device.assessments.some((a) => a.verdict === 'fail')).map((d) => d.name);
  const copies = devices.filter((device) => device.copy_of).map((device) => device.name);
  return (
    (isNumber(lot.tested) ? count(lot.tested, 'device') + ' with values' : 'Devices with values') +
    (isNumber(lot.size) ? ' of ' + lot.size : '') +
    (isNumber(lot.required) ? ', ' + lot.required + ' required' : '') + '.' +
    (copies.length > 0 ? ' Copies of a record (' + enumerate(copies) + ') count in n, mean and CoV, not in k.' : '') +
    ' CoV: standard deviation over the mean.' +
    ' Tolerance: interval that contains 95\u202f% of all devices with 95\u202f% confidence, if normally distributed.' +
    (failing.length > 0 ? ' Outside a limit: ' + enumerate(failing) + '.' : '')
  );
}

function lotTable() {
  const extreme = (value, device) =>
    element(
      'td',
      { class: 'number' },
      significant(value, 4),
      element('small', { title: device }, short(device ?? '', 16)),
    );
  const range = (low, high) =>
    isNumber(high) ? (isNumber(low) ? significant(low, 3) + ' \u2013 ' : 'to ') + significant(high, 3) : DASH;
  const below = (text) => (text ? element('small', {}, text) : null);
  const property = (q) =>
    element('span', {}, strong(q.quantity), q.unit ? ' ' + unitText(q.unit) : '');
  const verdict = (q) =>
    element('td', { class: 'reasoned' }, q.verdict ? verdictBadge(q.verdict) : DASH, below(q.reason));
  const deviations = (q) =>
    element(
      'td',
      { class: 'number' },
      deviation(q.deviation_of_mean_percent),
      below(isNumber(q.worst_deviation_percent) && 'worst ' + deviation(q.worst_deviation_percent)),
    );
  const limits = (q) =>
    element(
      'td',
      { class: 'tight' },
      limitText(q.limit_individual),
      below(q.limit_mean && 'mean: ' + limitText(q.limit_mean)),
    );
  const tolerance = (q) =>
    element(
      'td',
      { class: 'number' },
      range(q.tolerance_lower, q.tolerance_upper),
      below(isNumber(q.tolerance_k) && 'k ' + fixed(q.tolerance_k, 3)),
      below(q.no_lower_bound && 'too few devices for a lower bound'),
    );
  const columns = [
    { title: 'Property', pinned: true, cell: property },
    { title: 'Verdict', cell: verdict },
    { title: 'n', number: true, cell: (q) => (isNumber(q.n) ? String(q.n) : DASH) },
    { title: 'Mean', number: true, cell: (q) => significant(q.mean, 4) },
    { title: 'CoV', unit: '%', number: true, cell: (q) => fixed(q.cov_percent, 1) },
    { title: 'Smallest', unit: 'device', number: true, cell: (q) => extreme(q.min, q.min_device) },
    { title: 'Largest', unit: 'device', number: true, cell: (q) => extreme(q.max, q.max_device) },
    { title: 'Design value', number: true, cell: (q) => significant(q.nominal, 4) },
    { title: 'Deviation', unit: 'mean; worst', number: true, cell: deviations },
    { title: 'Limits', unit: 'each device; mean', cell: limits },
    { title: '5 to 95 %', unit: 'fractiles', number: true, cell: (q) => range(q.fractile_5, q.fractile_95) },
    { title: 'Tolerance', unit: '95/95, k', number: true, cell: tolerance },
  ];
  return tableOf(columns, lotQuantities, 'The lot, one row a property');
}

function lotData() {
  const { columns, cells } = resultColumns('quantities');
  return {
    columns: [
      ...columns, 'without', ...resultColumns('test_factors').columns, 'limit on the mean', 'verdict', 'reason',
    ],
    rows: lotQuantities.map((q) => [
      ...cells(q), q.without, q.lambda_test_min, q.lambda_test_min_cycle, q.lambda_test_max, q.lambda_test_max_cycle,
      q.limit_mean, q.verdict, q.reason,
    ]),
  };
}
