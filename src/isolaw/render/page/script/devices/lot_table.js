import { element, onScreen } from '../dom.js';
import { lotQuantities } from '../lot.js';
import { devices, report } from '../report.js';
import { table } from '../tables.js';
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
  return (
    (isNumber(lot.tested) ? count(lot.tested, 'device') + ' with values' : 'Devices with values') +
    (isNumber(lot.size) ? ' of ' + lot.size : '') +
    (isNumber(lot.required) ? ', ' + lot.required + ' required' : '') + '. CoV: standard deviation over the mean.' +
    onScreen(
      ' Tolerance: interval that holds 95\u202f% of all devices with 95\u202f% confidence, if normally distributed.',
    ) +
    (failing.length > 0 ? ' Outside a limit: ' + enumerate(failing) + '.' : '')
  );
}

function lotTable() {
  const columns = [
    { title: 'Property', pinned: true },
    { title: 'Verdict' },
    { title: 'n', number: true },
    { title: 'Mean', number: true },
    { title: 'CoV', unit: '%', number: true },
    { title: 'Smallest', unit: 'device', number: true },
    { title: 'Largest', unit: 'device', number: true },
    { title: 'Design value', number: true },
    { title: 'Deviation', unit: 'mean; worst', number: true },
    { title: 'Limits', unit: 'each device; mean' },
    { title: '5 to 95 %', unit: 'fractiles', number: true, screen: true },
    { title: 'Tolerance', unit: '95/95, k', number: true, screen: true },
  ];
  const extreme = (value, device) =>
    element(
      'td',
      { class: 'number' },
      significant(value, 4),
      element('small', { title: device }, short(device ?? '', 16)),
    );
  const range = (low, high) =>
    isNumber(high) ? (isNumber(low) ? significant(low, 3) + ' \u2013 ' : 'to ') + significant(high, 3) : DASH;
  const rows = lotQuantities.map((q) => ({
    cells: [
      element('span', {}, element('b', { class: 'strong' }, q.quantity), q.unit ? ' ' + unitText(q.unit) : ''),
      element(
        'td',
        { class: 'reasoned' },
        q.verdict ? verdictBadge(q.verdict) : DASH,
        q.reason ? element('small', {}, q.reason) : null,
      ),
      isNumber(q.n) ? String(q.n) : DASH,
      significant(q.mean, 4),
      fixed(q.cov_percent, 1),
      extreme(q.min, q.min_device),
      extreme(q.max, q.max_device),
      significant(q.nominal, 4),
      element(
        'td',
        { class: 'number' },
        deviation(q.deviation_of_mean_percent),
        isNumber(q.worst_deviation_percent)
          ? element('small', {}, 'worst ' + deviation(q.worst_deviation_percent))
          : null,
      ),
      element(
        'td',
        { class: 'tight' },
        limitText(q.limit_individual),
        q.limit_mean ? element('small', {}, 'mean: ' + limitText(q.limit_mean)) : null,
      ),
      range(q.fractile_5, q.fractile_95),
      element(
        'td',
        { class: 'number screen' },
        range(q.tolerance_lower, q.tolerance_upper),
        isNumber(q.tolerance_k) ? element('small', {}, 'k ' + fixed(q.tolerance_k, 3)) : null,
        q.no_lower_bound ? element('small', {}, q.no_lower_bound.split(':')[0]) : null,
      ),
    ],
  }));
  return table(columns, rows, 'The lot, one row a property');
}

function lotData() {
  const keys = Object.keys(lotQuantities[0]);
  return { columns: keys, rows: lotQuantities.map((quantity) => keys.map((key) => quantity[key])) };
}
